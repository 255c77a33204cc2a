#include <algorithm>
#include <derivations/algebra/syntax.hpp>
#include <derivations/algebra/unicode.hpp>

namespace rederive {

namespace {

constexpr const char* small_greek[] = {"alpha",   "beta", "gamma", "delta",  "epsilon", "zeta", "eta",
                                       "theta",   "iota", "kappa", "lambda", "mu",      "nu",   "xi",
                                       "omicron", "pi",   "rho",   "sigma",  "sigma",   "tau",  "upsilon",
                                       "phi",     "chi",  "psi",   "omega"};
constexpr const char* capital_greek[] = {"Alpha",   "Beta", "Gamma", "Delta",  "Epsilon", "Zeta", "Eta",
                                         "Theta",   "Iota", "Kappa", "Lambda", "Mu",      "Nu",   "Xi",
                                         "Omicron", "Pi",   "Rho",   "Sigma",  "",        "Tau",  "Upsilon",
                                         "Phi",     "Chi",  "Psi",   "Omega"};

struct Composed {
  char32_t code;
  char letter;
  char32_t mark;
};

/// The precomposed letters that a keyboard or NFC normalisation makes of a letter and a mark.
constexpr Composed composed[] = {
    {U'ȧ', 'a', dot_above}, {U'ḃ', 'b', dot_above}, {U'ċ', 'c', dot_above}, {U'ḋ', 'd', dot_above},
    {U'ė', 'e', dot_above}, {U'ḟ', 'f', dot_above}, {U'ġ', 'g', dot_above}, {U'ḣ', 'h', dot_above},
    {U'ṁ', 'm', dot_above}, {U'ṅ', 'n', dot_above}, {U'ȯ', 'o', dot_above}, {U'ṗ', 'p', dot_above},
    {U'ṙ', 'r', dot_above}, {U'ṡ', 's', dot_above}, {U'ṫ', 't', dot_above}, {U'ẇ', 'w', dot_above},
    {U'ẋ', 'x', dot_above}, {U'ẏ', 'y', dot_above}, {U'ż', 'z', dot_above}, {U'Ė', 'E', dot_above},
    {U'Ḣ', 'H', dot_above}, {U'Ṙ', 'R', dot_above}, {U'ä', 'a', diaeresis}, {U'ë', 'e', diaeresis},
    {U'ḧ', 'h', diaeresis}, {U'ï', 'i', diaeresis}, {U'ö', 'o', diaeresis}, {U'ẗ', 't', diaeresis},
    {U'ü', 'u', diaeresis}, {U'ẅ', 'w', diaeresis}, {U'ẍ', 'x', diaeresis}, {U'ÿ', 'y', diaeresis},
    {U'Ä', 'A', diaeresis}, {U'Ö', 'O', diaeresis}, {U'Ü', 'U', diaeresis}, {U'Ā', 'A', macron},
    {U'ā', 'a', macron},    {U'Ē', 'E', macron},    {U'ē', 'e', macron},    {U'ū', 'u', macron}};

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
    if (is_space(code)) {
      characters.push_back({' ', position});
      continue;
    }
    if (is_control(code))
      throw SyntaxError("character", position, "there is an invisible control character here");
    const auto* pair = std::find_if(std::begin(composed), std::end(composed),
                                    [code = code](const Composed& entry) { return entry.code == code; });
    if (pair == std::end(composed)) {
      characters.push_back({code, position});
    } else {
      characters.push_back({static_cast<char32_t>(pair->letter), position});
      characters.push_back({pair->mark, position});
    }
  }
  return characters;
}

std::string encode(char32_t code) {
  const auto byte = [](char32_t bits) { return static_cast<char>(static_cast<unsigned char>(bits)); };
  if (code < 0x80) return {byte(code)};
  if (code < 0x800) return {byte(0xC0 | code >> 6), byte(0x80 | (code & 0x3F))};
  if (code < 0x10000) {
    return {byte(0xE0 | code >> 12), byte(0x80 | (code >> 6 & 0x3F)), byte(0x80 | (code & 0x3F))};
  }
  return {byte(0xF0 | code >> 18), byte(0x80 | (code >> 12 & 0x3F)), byte(0x80 | (code >> 6 & 0x3F)),
          byte(0x80 | (code & 0x3F))};
}

std::string_view greek_name(char32_t code) {
  switch (code) {  // variants of letters that have a code point of their own
    case 0x3D1:
      return "theta";
    case 0x3D5:
      return "phi";
    case 0x3F5:
      return "epsilon";
    case 0xB5:
      return "mu";
    case 0x2126:
      return "Omega";
    default:
      break;
  }
  if (code >= U'α' && code <= U'ω') return small_greek[code - U'α'];
  if (code >= U'Α' && code <= U'Ω') return capital_greek[code - U'Α'];
  return {};
}

int superscript_digit(char32_t code) {
  if (code == U'¹') return 1;
  if (code == U'²') return 2;
  if (code == U'³') return 3;
  return code == U'⁰' || (code >= U'⁴' && code <= U'⁹') ? static_cast<int>(code - U'⁰') : -1;
}

int subscript_digit(char32_t code) {
  return code >= U'₀' && code <= U'₉' ? static_cast<int>(code - U'₀') : -1;
}

std::string number_of(char32_t code) {
  std::string digits;
  for (auto rest = static_cast<unsigned long>(code); rest > 0 || digits.size() < 4; rest /= 16)
    digits.insert(0, 1, "0123456789ABCDEF"[rest % 16]);
  return "U+" + digits;
}

int width(char32_t code) { return code >= 0x300 && code < 0x370 ? 0 : 1; }

}  // namespace rederive
