// UTF-8 in, code points out: the few letters and marks that formulas are written with.
#pragma once

#include <cstddef>
#include <derivations/language/utf8.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rederive {

/// One code point and the byte at which it begins.
struct Character {
  char32_t code;
  std::size_t position;
};

constexpr char32_t dot_above = 0x307, diaeresis = 0x308, macron = 0x304;
/// Whether a terminal shows it above or below the character before.
inline bool is_combining(char32_t code) { return code >= 0x300 && code < 0x370; }

/// Letters with dots come back as the letter and its combining mark (ü is u and U+0308), other spaces as ' '.
/// Throws SyntaxError "character" for bytes that are not UTF-8 and for control characters.
std::vector<Character> decode(std::string_view text);
/// The code point in UTF-8; nothing is checked.
std::string encode(char32_t code);

/// "theta" for θ; empty if it is no Greek letter.
std::string greek_name(char32_t code);
/// The digit of a superscript or subscript, or -1.
int superscript_digit(char32_t code);
int subscript_digit(char32_t code);
/// "²" for '2'.
std::string superscript(char digit);

}  // namespace rederive
