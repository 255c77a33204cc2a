#include <algorithm>
#include <derivations/language/syntax.hpp>
#include <derivations/language/unicode.hpp>

namespace rederive {

std::string explain(const SyntaxError& error, std::string_view text) {
  const std::size_t position = std::min(error.position, text.size()),
                    start = text.substr(0, position).rfind('\n') + 1,  // 0 on the first line
      end = std::min(text.find('\n', position), text.size());
  // A long line is shown around the character at fault.
  constexpr std::size_t before = 80, after = 60;  // bytes
  const std::size_t first = std::max(start, std::max(position, before) - before),
                    last = std::min(end, position + after);
  std::string shown = first > start ? "…" : "", indent = first > start ? " " : "";
  for (std::size_t at = start, bytes = 1; at < last; at += std::max<std::size_t>(bytes, 1)) {
    const CodePoint character = first_character(text.substr(at));
    bytes = character.bytes;
    if (at < first) continue;
    const bool is_shown = bytes > 0 && !is_control(character.code) && !is_invisible(character.code);
    shown += is_shown ? text.substr(at, bytes) : is_space(character.code) ? " " : "?";
    if (at < position && !is_combining(character.code)) indent += ' ';
  }
  return std::string(error.what()) + "\n  " + shown + (last < end ? "…" : "") + "\n  " + indent + "^";
}

}  // namespace rederive
