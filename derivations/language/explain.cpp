#include <algorithm>
#include <derivations/language/explain.hpp>
#include <derivations/language/unicode.hpp>

namespace rederive {

namespace {

/// The line as a terminal can show it, a code point an entry: what cannot be shown becomes '?'.
std::vector<Character> showable(std::string_view line) {
  std::vector<Character> characters;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t bytes = std::max<std::size_t>(first_character(line.substr(at)).bytes, 1);
    try {
      for (const Character& part : decode(line.substr(at, bytes)))
        characters.push_back({is_invisible(part.code) ? U'?' : part.code, at});
    } catch (const SyntaxError&) {
      characters.push_back({'?', at});
    }
    at += bytes;
  }
  return characters;
}

}  // namespace

std::string explain(const SyntaxError& error, std::string_view text) {
  const std::size_t position = std::min(error.position, text.size());
  const std::size_t newline = position == 0 ? std::string_view::npos : text.rfind('\n', position - 1);
  const std::size_t start = newline == std::string_view::npos ? 0 : newline + 1;
  const std::vector<Character> line =
      showable(text.substr(start, std::min(text.find('\n', position), text.size()) - start));
  const auto is_before = [&](const Character& c) { return start + c.position < position; };
  const auto at_fault =
      static_cast<std::size_t>(std::find_if_not(line.begin(), line.end(), is_before) - line.begin());

  // A long line is shown around the character at fault.
  constexpr std::size_t before = 60, after = 40;
  const std::size_t first = at_fault > before ? at_fault - before : 0;
  const std::size_t last = std::min(line.size(), at_fault + after);
  std::string shown = first > 0 ? "…" : "", indent = first > 0 ? " " : "";
  for (std::size_t i = first; i < last; ++i) {
    shown += encode(line[i].code);
    if (i < at_fault && !is_combining(line[i].code)) indent += ' ';
  }
  if (last < line.size()) shown += "…";
  return std::string(error.what()) + "\n  " + shown + "\n  " + indent + "^";
}

}  // namespace rederive
