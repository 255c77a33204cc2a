#include <fmt/format.h>

#include <algorithm>
#include <derivations/program/program.hpp>
#include <numerics/records/record_file.hpp>
#include <stdexcept>
#include <string_view>

namespace rederive::numerics {
using namespace program;
namespace {

using namespace std::string_view_literals;

constexpr std::size_t most_lines = 1'000'000, longest_line = 100'000;

/// Returns what the file holds. Throws std::invalid_argument if it cannot be read.
std::string bytes_of(const std::string& file) {
  FileContent content = content_of(file);
  if (content.trouble != FileTrouble::none) throw std::invalid_argument(content.complaint);
  return std::move(content.bytes);
}

/// Returns whether each second byte at the beginning is 0, from the first byte on (0) or from the second on
/// (1), as in ASCII text in UTF-16.
bool has_zeros(std::string_view bytes, std::size_t from) {
  const std::string_view begin = bytes.substr(0, 64);
  if (begin.size() < 8 || bytes.size() % 2 != 0) return false;
  for (std::size_t i = 0; i < begin.size(); ++i)
    if ((begin[i] == '\0') != (i % 2 == from)) return false;
  return true;
}

void append_utf8(std::string& text, unsigned unit) {
  const auto add = [&](unsigned byte) { text += static_cast<char>(byte); };
  if (unit < 0x80) {
    add(unit);
  } else if (unit < 0x800) {
    add(0xC0 | unit >> 6), add(0x80 | (unit & 0x3F));
  } else if (unit < 0xD800 || unit > 0xDFFF) {
    add(0xE0 | unit >> 12), add(0x80 | (unit >> 6 & 0x3F)), add(0x80 | (unit & 0x3F));
  } else {
    add('?');  // half of a character that no record needs
  }
}

std::string from_utf16(std::string_view bytes, bool little) {
  std::string text;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2) {
    const auto first = static_cast<unsigned char>(bytes[i]),
               second = static_cast<unsigned char>(bytes[i + 1]);
    append_utf8(text, little ? first | unsigned{second} << 8 : second | unsigned{first} << 8);
  }
  return text;
}

void replace_all(std::string& text, std::string_view what, std::string_view by) {
  for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
    text.replace(at, what.size(), by);
}

std::string decoded(std::string bytes, const std::string& file) {
  const std::string_view view = bytes;
  if (view.starts_with("\x1F\x8B"sv) || view.starts_with("PK\x03\x04"sv))
    throw std::invalid_argument("'" + printable_name(file) + "' is compressed: unpack it first");
  if (view.starts_with("\xFF\xFE\0\0"sv) || view.starts_with("\0\0\xFE\xFF"sv))
    throw std::invalid_argument("'" + printable_name(file) + "' is in UTF-32: use UTF-8, UTF-16 or Latin-1");
  const bool has_mark = view.starts_with("\xFF\xFE"sv) || view.starts_with("\xFE\xFF"sv);
  if (has_mark && view.size() % 2 != 0)
    throw std::invalid_argument("'" + printable_name(file) +
                                "' is in UTF-16 and ends inside a character: it is cut off");
  if (has_mark) return from_utf16(view.substr(2), view[0] == '\xFF');
  if (has_zeros(view, 0) || has_zeros(view, 1)) return from_utf16(view, has_zeros(view, 1));
  return view.starts_with("\xEF\xBB\xBF"sv) ? bytes.substr(3) : bytes;
}

/// Returns the lines, each of which ends with LF, CR, or CRs and LF.
std::vector<std::string> split(std::string_view text, const std::string& file) {
  std::vector<std::string> lines;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_of("\r\n"), text.size());
    if (lines.size() >= most_lines) refuse(file, lines.size(), "the file has more than a million lines");
    if (length > longest_line)
      refuse(file, lines.size() + 1, fmt::format("the line has more than {} characters", longest_line));
    lines.emplace_back(text.substr(0, length));
    const std::size_t behind = std::min(text.find_first_not_of('\r', length), text.size());
    const bool has_feed = behind < text.size() && text[behind] == '\n';
    text.remove_prefix(has_feed ? behind + 1 : std::min(length + 1, text.size()));
  }
  return lines;
}

}  // namespace

void refuse(const std::string& file, std::size_t line, std::string why) {
  std::ranges::replace(why, '\0', '?');  // or the message would end there
  throw std::invalid_argument(fmt::format("{}:{}: {}", printable_name(file), line, why));
}

std::vector<std::string> lines_of_record(const std::string& file) {
  std::string text = decoded(bytes_of(file), file);
  constexpr char end_of_file = '\x1A';
  const std::size_t last = text.find_last_not_of("\0\x1A"sv);
  text.erase(last == std::string::npos ? 0 : last + 1);
  replace_all(text, "\u2212", "-");
  replace_all(text, "\u00A0", " ");
  std::vector<std::string> lines = split(text, file);
  for (std::size_t i = 0; i < lines.size(); ++i)
    if (lines[i].find(end_of_file) != std::string::npos)
      refuse(file, i + 1, "the file continues after an end mark (Ctrl-Z)");
  return lines;
}

}  // namespace rederive::numerics
