// Text: UTF-8, the letters and marks of formulas, and the known word that is nearest to a misspelt one.
#pragma once

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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
  return std::ranges::any_of(ranges, [&](const auto& range) { return code >= range[0] && code <= range[1]; });
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

constexpr std::size_t longest_name = 40;  ///< names longer than this have no nearest word

inline std::string lower_case(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

/// Returns the least number of edits between two words (Damerau–Levenshtein, each letter moved at most once).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
  for (std::size_t i = 0; i <= a.size(); ++i) {
    for (std::size_t j = 0; j <= b.size(); ++j) {
      std::size_t& least = d[i][j] = i + j;
      if (i == 0 || j == 0) continue;
      const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      least = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        least = std::min(least, d[i - 2][j - 2] + 1);
    }
  }
  return d[a.size()][b.size()];
}

/// Returns the first of the nearest known words, or ""; words that differ in case alone are the nearest.
inline std::string nearest(std::string_view name, const std::vector<std::string>& known) {
  if (name.size() > longest_name) return {};
  std::string best;
  std::size_t smallest = 1 + (name.size() + 1) / 3;  // a slip in every third letter; none in a single one
  for (const std::string& candidate : known) {
    const bool same = lower_case(name) == lower_case(candidate);
    const std::size_t distance = same ? 0 : edit_distance(name, candidate);
    if (distance < smallest) smallest = distance, best = candidate;
  }
  return best;
}

/// Returns ": did you mean 'alpha'?", or "" if there is no name.
inline std::string did_you_mean(const std::string& name) {
  return name.empty() ? "" : ": did you mean '" + name + "'?";
}

}  // namespace rederive::language
