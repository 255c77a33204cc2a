#include <algorithm>
#include <derivations/language/syntax_error.hpp>
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

/// The precomposed letters that a keyboard or NFC normalisation makes of a letter and a mark, each before its
/// letter.
struct Composed {
  char32_t mark;
  std::u32string_view pairs;
};
constexpr Composed composed[] = {{dot_above, U"ȧaḃbċcḋdėeḟfġgḣhṁmṅnȯoṗpṙrṡsṫtẇwẋxẏyżzĖEḢHṘR"},
                                 {diaeresis, U"äaëeḧhïiöoẗtüuẅwẍxÿyÄAÖOÜU"},
                                 {macron, U"ĀAāaĒEēeūu"}};

bool is_space(char32_t code) {
  return code == ' ' || code == '\t' || code == '\n' || code == '\r' || code == 0xA0 || code == 0x202F ||
         (code >= 0x2000 && code <= 0x200A);
}

}  // namespace

std::vector<Character> decode(std::string_view text) {
  std::vector<Character> characters;
  characters.reserve(text.size());
  for (std::size_t position = 0, next = 0; position < text.size(); position = next) {
    const auto [code, bytes] = first_character(text.substr(position));
    if (bytes == 0) throw SyntaxError("character", position, "these bytes are not UTF-8 text");
    next = position + bytes;
    if (is_control(code) && !is_space(code))
      throw SyntaxError("character", position, "there is an invisible control character here");
    characters.push_back({is_space(code) ? U' ' : code, position});
    if (code < 0x80) continue;
    for (const auto& [mark, pairs] : composed) {
      const std::size_t pair = pairs.find(code);
      if (pair == std::u32string_view::npos) continue;
      characters.back().code = pairs[pair + 1];
      characters.push_back({mark, position});
    }
  }
  return characters;
}

std::string encode(char32_t code) {
  const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  const auto tail = [&](int shift) { return byte(0x80 | (code >> shift & 0x3F)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6), tail(0)};
  if (code < 0x10000) return {byte(0xE0 | code >> 12), tail(6), tail(0)};
  return {byte(0xF0 | code >> 18), tail(12), tail(6), tail(0)};
}

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

std::string superscript(char digit) { return encode(superscripts[static_cast<std::size_t>(digit - '0')]); }

}  // namespace rederive
