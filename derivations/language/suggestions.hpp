// What was probably meant instead: the errors of the parser that come with a suggestion.
#pragma once

#include <derivations/language/lexer.hpp>

namespace rederive {

/// A text, its tokens, and the symbols that may stand in it. `at` and the like are indices of tokens.
struct Formula {
  std::string_view text;
  const std::vector<Token>& tokens;
  const Symbols& symbols;
};

/// Whether a token can begin an operand.
bool starts_operand(const Token& token);
/// Whether it is the name of a function, pow included.
bool is_function(const Token& token);

/// 3/2x: in the product that begins at token `product`, the factor from `first` is followed at once by `at`.
SyntaxError juxtaposition(const Formula& formula, std::size_t product, std::size_t first, std::size_t at);
/// m(b + h): a symbol is followed by a parenthesis.
SyntaxError called_symbol(const Formula& formula, std::size_t name);
/// sin x, sin^2(x), sin: a function is not followed by a parenthesis.
SyntaxError bare_function(const Formula& formula, std::size_t function);
/// sin⁻¹(x), sin^-1(x): `at` is the exponent.
SyntaxError ambiguous_inverse(const Token& function, const Token& at);
/// thta, mgR, sin2x, inf: a name that is neither a symbol nor a function.
SyntaxError unknown_name(const Formula& formula, std::size_t name);
/// x*, (), ²: at this token an operand should begin, and none does.
SyntaxError missing_operand(const Formula& formula, std::size_t at);
/// 3,5: a comma that is not between the arguments of a function.
SyntaxError stray_comma(const Formula& formula, std::size_t at);

}  // namespace rederive
