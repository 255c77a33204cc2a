#include <algorithm>
#include <derivations/language/syntax_error.hpp>
#include <derivations/language/unicode.hpp>
#include <vector>

namespace rederive {

std::string explain(const SyntaxError& error, std::string_view text) {
  const std::size_t position = std::min(error.position, text.size());
  const std::size_t start = text.substr(0, position).rfind('\n') + 1;  // 0 on the first line
  const std::string_view line = text.substr(start, text.find('\n', position) - start);
  std::vector<std::string> characters;  // as a terminal can show them: what cannot be shown becomes '?'
  std::size_t at_fault = 0;
  for (std::size_t at = 0; at < line.size();) {
    const auto [code, bytes] = first_character(line.substr(at));
    const bool is_shown = bytes > 0 && !is_control(code) && !is_invisible(code);
    characters.push_back(is_shown ? std::string(line.substr(at, bytes)) : is_space(code) ? " " : "?");
    at_fault += start + at < position ? 1 : 0;
    at += std::max<std::size_t>(bytes, 1);
  }

  // A long line is shown around the character at fault.
  constexpr std::size_t before = 60, after = 40;
  const std::size_t first = at_fault > before ? at_fault - before : 0;
  const std::size_t last = std::min(characters.size(), at_fault + after);
  std::string shown = first > 0 ? "…" : "", indent = first > 0 ? " " : "";
  for (std::size_t i = first; i < last; ++i) {
    shown += characters[i];
    if (i < at_fault && !is_combining(first_character(characters[i]).code)) indent += ' ';
  }
  if (last < characters.size()) shown += "…";
  return std::string(error.what()) + "\n  " + shown + "\n  " + indent + "^";
}

}  // namespace rederive
