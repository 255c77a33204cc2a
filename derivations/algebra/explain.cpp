// Errors that point at the character.
#include <algorithm>
#include <derivations/algebra/syntax.hpp>
#include <derivations/algebra/unicode.hpp>

namespace rederive {

SyntaxError::SyntaxError(std::string given_note, std::size_t given_position, const std::string& message)
    : std::runtime_error(message), note(std::move(given_note)), position(given_position) {}

namespace {

/// The line as a terminal can show it, a code point an entry: what cannot be shown becomes '?'.
std::vector<Character> showable(std::string_view line) {
  std::vector<Character> characters;
  for (std::size_t at = 0; at < line.size();) {
    std::size_t length = 1;
    while (at + length < line.size() && length < 4 && (line[at + length] & 0xC0) == 0x80) ++length;
    const bool ascii = static_cast<unsigned char>(line[at]) < 0x80;
    if (ascii) length = 1;
    try {
      for (const Character& part : decode(line.substr(at, length))) {
        characters.push_back({is_invisible(part.code) ? U'?' : part.code, at + part.position});
      }
    } catch (const SyntaxError&) {
      characters.push_back({'?', at});
    }
    at += length;
  }
  return characters;
}

}  // namespace

std::string explain(const SyntaxError& error, std::string_view text) {
  const std::size_t position = std::min(error.position, text.size());
  const std::size_t newline = position == 0 ? std::string_view::npos : text.rfind('\n', position - 1);
  const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
  const std::string_view line = text.substr(start, std::min(text.find('\n', position), text.size()) - start);

  // A long line is shown around the character at fault.
  constexpr std::size_t before = 60, after = 40;
  const std::vector<Character> characters = showable(line);
  const auto at_fault = static_cast<std::size_t>(
      std::find_if(characters.begin(), characters.end(),
                   [&](const Character& c) { return start + c.position >= position; }) -
      characters.begin());
  const std::size_t first = at_fault > before ? at_fault - before : 0;
  const std::size_t last = std::min(characters.size(), at_fault + after);
  std::string shown = first > 0 ? "…" : "", indent = first > 0 ? " " : "";
  for (std::size_t i = first; i < last; ++i) {
    shown += encode(characters[i].code);
    if (i < at_fault) indent += std::string(static_cast<std::size_t>(width(characters[i].code)), ' ');
  }
  if (last < characters.size()) shown += "…";
  return std::string(error.what()) + "\n  " + shown + "\n  " + indent + "^";
}

}  // namespace rederive
