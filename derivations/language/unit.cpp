#include <algorithm>
#include <cctype>
#include <derivations/language/unicode.hpp>
#include <derivations/language/unit.hpp>
#include <sstream>
#include <stdexcept>

namespace rederive {

namespace {

constexpr std::array<const char*, 3> base_units = {"kg", "m", "s"};

std::string power_text(const char* unit, const GiNaC::numeric& power) {
  if (power == 1) return unit;
  std::ostringstream plain;
  plain << power;
  if (!power.is_integer()) return std::string(unit) + "^(" + plain.str() + ")";
  std::string text = unit;
  for (char digit : plain.str()) text += superscript(digit);
  return text;
}

}  // namespace

Dimension parse_unit(std::string_view text) {
  Dimension dimension{0, 0, 0};
  if (text == "1") return dimension;
  int sign = text.starts_with("1/") ? -1 : 1;
  for (std::size_t at = sign < 0 ? 2 : 0;; ++at) {
    const auto base = std::find_if(base_units.begin(), base_units.end(), [&](std::string_view unit) {
      return text.substr(std::min(at, text.size())).starts_with(unit);
    });
    if (base == base_units.end()) break;
    at += std::string_view(*base).size();
    const bool raised = text.substr(at).size() > 1 && text[at] == '^' &&
                        std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0;
    const int power = raised ? text[at + 1] - '0' : 1;
    dimension[static_cast<std::size_t>(base - base_units.begin())] += sign * power;
    at += raised ? 2 : 0;
    if (at == text.size()) return dimension;
    if (text[at] != '*' && text[at] != '/') break;
    sign = text[at] == '*' ? 1 : -1;
  }
  throw std::invalid_argument("a unit is written like 'kg*m^2/s^2', not '" + std::string(text) + "'");
}

std::string unit_text(const Dimension& dimension) {
  std::string above, below;
  for (std::size_t i = 0; i < base_units.size(); ++i) {
    if (dimension[i].is_zero()) continue;
    std::string& side = dimension[i].is_negative() ? below : above;
    side += (side.empty() ? "" : "·") + power_text(base_units[i], GiNaC::abs(dimension[i]));
  }
  if (above.empty()) above = "1";
  if (below.empty()) return above;
  const bool several = below.find("·") != std::string::npos;
  return above + "/" + (several ? "(" + below + ")" : below);
}

}  // namespace rederive
