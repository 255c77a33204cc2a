// Units of the SI, as text and as exponents of kg, m, s.
#include <cctype>
#include <derivations/algebra/dimension.hpp>
#include <stdexcept>

namespace rederive {

namespace {

constexpr std::array<const char*, 3> base_units = {"kg", "m", "s"};

[[noreturn]] void refuse(std::string_view text) {
  throw std::invalid_argument("a unit is written like 'kg*m^2/s^2', not '" + std::string(text) + "'");
}

/// Reads "kg" or "m^2" at `at` and adds it with its sign.
void read_factor(std::string_view text, std::size_t& at, int sign, Dimension& dimension) {
  std::size_t end = at;
  while (end < text.size() && std::isalpha(static_cast<unsigned char>(text[end]))) ++end;
  const std::string_view name = text.substr(at, end - at);
  int power = 1;
  if (end + 1 < text.size() && text[end] == '^' && std::isdigit(static_cast<unsigned char>(text[end + 1]))) {
    power = text[end + 1] - '0';
    end += 2;
  }
  at = end;
  for (std::size_t i = 0; i < base_units.size(); ++i) {
    if (name != base_units[i]) continue;
    dimension[i] += GiNaC::numeric(sign * power);
    return;
  }
  refuse(text);
}

const char* superscript(char digit) {
  static constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return digits.at(static_cast<std::size_t>(digit - '0'));
}

std::string power_text(const char* unit, const GiNaC::numeric& power) {
  if (power == 1) return unit;
  std::ostringstream plain;
  plain << power;
  if (!power.is_integer()) return std::string(unit) + "^(" + plain.str() + ")";
  std::string text = unit;
  for (char c : plain.str()) text += superscript(c);
  return text;
}

}  // namespace

Dimension parse_unit(std::string_view text) {
  Dimension dimension{0, 0, 0};
  std::size_t at = 0;
  int sign = 1;
  if (text.starts_with('1')) {  // "1" or "1/s"
    if (text == "1") return dimension;
    at = 1;
    if (text[at] != '/') refuse(text);
    sign = -1;
    ++at;
  }
  while (true) {
    read_factor(text, at, sign, dimension);
    if (at == text.size()) return dimension;
    if (text[at] != '*' && text[at] != '/') refuse(text);
    sign = text[at] == '*' ? 1 : -1;
    ++at;
  }
}

std::string unit_text(const Dimension& dimension) {
  std::string above, below;
  int divisors = 0;
  for (std::size_t i = 0; i < base_units.size(); ++i) {
    const GiNaC::numeric& power = dimension[i];
    if (power.is_zero()) continue;
    std::string& side = power.is_negative() ? below : above;
    if (power.is_negative()) ++divisors;
    if (!side.empty()) side += "·";
    side += power_text(base_units[i], GiNaC::abs(power));
  }
  if (below.empty()) return above.empty() ? "1" : above;
  return (above.empty() ? "1" : above) + "/" + (divisors > 1 ? "(" + below + ")" : below);
}

}  // namespace rederive
