// What was probably meant instead: the errors of the parser that come with a suggestion.
#pragma once

#include <derivations/algebra/tokens.hpp>

namespace rederive {

/// Makes the errors for one text. `at` and the like are indices of its tokens.
class Advice {
 public:
  Advice(std::string_view text, const std::vector<Token>& tokens, const Symbols& symbols)
      : text_(text), tokens_(tokens), symbols_(symbols) {}

  /// 3/2x: in the product that begins at token `product`, the factor from `first` is followed at once by
  /// `at`.
  SyntaxError juxtaposition(std::size_t product, std::size_t first, std::size_t at) const;
  /// m(b + h): a symbol is followed by a parenthesis.
  SyntaxError called_symbol(std::size_t name) const;
  /// sin x, sin^2(x), sin: a function is not followed by a parenthesis.
  SyntaxError bare_function(std::size_t function) const;
  /// thta, mgR, sin2x, inf: a name that is neither a symbol nor a function.
  SyntaxError unknown_name(std::size_t name) const;
  /// x*, (), ²: at this token an operand should begin, and none does.
  SyntaxError missing_operand(std::size_t at) const;
  /// 3,5: a comma that is not between the arguments of a function.
  SyntaxError stray_comma(std::size_t at) const;

 private:
  /// How a stretch of tokens should be written, and the token behind it.
  struct Meant {
    std::string text;
    std::size_t next;
  };

  SyntaxError error(const char* note, const std::string& message, std::size_t at) const;
  std::string written(std::size_t first, std::size_t last) const;
  bool is_function(std::size_t at) const;
  Meant operand(std::size_t at) const;
  Meant call(std::size_t function) const;
  Meant group(std::size_t opening) const;
  Meant factors(std::size_t at) const;
  std::string glued_call(const std::string& name) const;

  std::string_view text_;
  const std::vector<Token>& tokens_;
  const Symbols& symbols_;
};

/// Whether a token can begin an operand.
bool starts_operand(const Token& token);

}  // namespace rederive
