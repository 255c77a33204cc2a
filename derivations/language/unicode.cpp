#include <derivations/language/unicode.hpp>
#include <utility>

namespace rederive {

namespace {

constexpr const char* greek[] = {"alpha",   "beta", "gamma", "delta",  "epsilon", "zeta", "eta",
                                 "theta",   "iota", "kappa", "lambda", "mu",      "nu",   "xi",
                                 "omicron", "pi",   "rho",   "sigma",  "sigma",   "tau",  "upsilon",
                                 "phi",     "chi",  "psi",   "omega"};
/// Letters that have a second code point.
constexpr std::pair<char32_t, const char*> variants[] = {
    {0x3D1, "theta"}, {0x3D5, "phi"}, {0x3F5, "epsilon"}, {0xB5, "mu"}, {0x2126, "Omega"}};
constexpr std::u32string_view superscripts = U"⁰¹²³⁴⁵⁶⁷⁸⁹";

}  // namespace

std::string greek_name(char32_t code) {
  for (const auto& [variant, name] : variants)
    if (code == variant) return name;
  if (code >= U'α' && code <= U'ω') return greek[code - U'α'];
  if (code < U'Α' || code > U'Ω' || code == 0x3A2) return {};  // where a final Σ would stand
  std::string name = greek[code - U'Α'];
  name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

int superscript_digit(char32_t code) {
  const std::size_t digit = superscripts.find(code);
  return digit == std::u32string_view::npos ? -1 : static_cast<int>(digit);
}

int subscript_digit(char32_t code) {
  return code >= U'₀' && code <= U'₉' ? static_cast<int>(code - U'₀') : -1;
}

std::string superscript(char digit) {
  constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  return digits[digit - '0'];
}

}  // namespace rederive
