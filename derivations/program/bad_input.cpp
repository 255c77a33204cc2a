#include <algorithm>
#include <derivations/language/text.hpp>
#include <derivations/program/bad_input.hpp>

namespace rederive::program {
using namespace language;

std::string printable(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto [code, bytes] = first_character(text);
    const bool is_shown = bytes > 0 && (code == '\n' || !is_control(code)) && !is_invisible(code);
    result += is_shown ? std::string(text.substr(0, bytes)) : "?";
    text.remove_prefix(std::max<std::size_t>(bytes, 1));
  }
  return result;
}

std::string printable_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', '?');
  return printable(text);
}

std::string printable_name(const std::filesystem::path& file) { return printable_line(file.string()); }

}  // namespace rederive::program
