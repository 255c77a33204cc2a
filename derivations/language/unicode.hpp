// UTF-8, and the letters and marks of formulas, for reading formulas and for writing messages.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

namespace rederive::language {

/// A code point and its number of bytes in UTF-8; 0 bytes if there is no code point.
struct CodePoint {
  char32_t code = 0;
  std::size_t bytes = 0;
};

/// Returns the first code point of a text; none if the text is empty or does not begin with UTF-8.
inline CodePoint first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  if (text.empty() || (byte(0) >= 0x80 && byte(0) < 0xC2) || byte(0) >= 0xF5) return {};
  const std::size_t length = byte(0) < 0x80 ? 1 : byte(0) < 0xE0 ? 2 : byte(0) < 0xF0 ? 3 : 4;
  if (length > text.size()) return {};
  char32_t code = length == 1 ? byte(0) : byte(0) & (0x7FU >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0) != 0x80) return {};
    code = (code << 6) | (byte(k) & 0x3FU);
  }
  constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool is_surrogate = code >= 0xD800 && code < 0xE000;
  if (code < smallest[length] || is_surrogate || code > 0x10FFFF) return {};
  return {code, length};
}

/// Returns whether a reader cannot see this mark, or it changes the direction of the text after it.
inline bool is_invisible(char32_t code) {
  constexpr char32_t ranges[][2] = {{0xAD, 0xAD},     {0x200B, 0x200F}, {0x2028, 0x202E},  {0x2060, 0x206F},
                                    {0xFEFF, 0xFEFF}, {0xFFF0, 0xFFFB}, {0xE0000, 0xE0FFF}};
  return std::any_of(std::begin(ranges), std::end(ranges),
                     [&](const auto& range) { return code >= range[0] && code <= range[1]; });
}

/// Returns whether this moves the cursor or changes colours; the end of a line does.
inline bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

/// Returns whether this is a blank; the end of a line is one.
inline bool is_space(char32_t code) {
  return code == ' ' || code == '\t' || code == '\n' || code == '\r' || code == 0xA0 || code == 0x202F ||
         (code >= 0x2000 && code <= 0x200A);
}

/// Returns the name of a Greek letter, "theta" for θ; "" for other characters.
inline std::string greek_name(char32_t code) {
  constexpr const char* names[] = {"alpha",   "beta", "gamma", "delta",  "epsilon", "zeta", "eta",
                                   "theta",   "iota", "kappa", "lambda", "mu",      "nu",   "xi",
                                   "omicron", "pi",   "rho",   "sigma",  "sigma",   "tau",  "upsilon",
                                   "phi",     "chi",  "psi",   "omega"};
  constexpr char32_t variants[][2] = {
      {0x3D1, U'θ'}, {0x3D5, U'φ'}, {0x3F5, U'ε'}, {0xB5, U'μ'}, {0x2126, U'Ω'}};  // second code points
  for (const auto& [variant, letter] : variants)
    if (code == variant) code = letter;
  if (code >= U'α' && code <= U'ω') return names[code - U'α'];
  if (code < U'Α' || code > U'Ω' || code == 0x3A2) return {};  // the unused place of a final Σ
  std::string name = names[code - U'Α'];
  name[0] = static_cast<char>(name[0] - 'a' + 'A');
  return name;
}

/// Returns digits as superscripts: "²³" for "23".
inline std::string superscript(std::string_view digits) {
  constexpr const char* raised[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text;
  for (const char digit : digits) text += raised[digit - '0'];
  return text;
}

/// Returns the digit of a superscript or subscript, or -1.
inline int superscript_digit(char32_t code) {
  constexpr std::u32string_view digits = U"⁰¹²³⁴⁵⁶⁷⁸⁹";
  const std::size_t digit = digits.find(code);
  return digit == digits.npos ? -1 : static_cast<int>(digit);
}
inline int subscript_digit(char32_t code) {
  return code >= U'₀' && code <= U'₉' ? static_cast<int>(code - U'₀') : -1;
}

}  // namespace rederive::language
