// Text → tokens, bounds checked on the way.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rederive {

struct Token {
  enum class Kind {
    number,       ///< digits as written
    name,         ///< in ASCII, whether known or not
    superscript,  ///< an integer exponent: "2", "-1"
    mark,         ///< + - * / ^ ( ) , and "sqrt" for √
    relation,     ///< = < <= > >=
    end
  };
  Kind kind;
  std::string text;
  std::size_t position, end;  ///< bytes

  /// Whether it is this mark: "(", or "sqrt", which is √; a name that is typed as sqrt is none.
  bool is(std::string_view mark) const { return kind == Kind::mark && text == mark; }
  bool starts_operand() const { return kind == Kind::number || kind == Kind::name || is("(") || is("sqrt"); }
};

/// The last token is the end. A name that is none, and sticks together from known ones, comes as these: mgR
/// as three. Pi is read as pi, and other look-alikes of it are refused. Throws SyntaxError.
std::vector<Token> tokenize(std::string_view text, const Symbols& symbols, const Limits& limits);

/// The known words that a name sticks together from, at most three: {"m", "g", "R"} for mgR, {"sin", "2",
/// "x"} for sin2x. The name alone where it is known, or more like a slip of the pen; that is none of three
/// typed characters, such as αp, or of fewer.
std::vector<std::string> words_in(const std::string& name, std::size_t characters, const Symbols& symbols);
/// A product that was typed without its signs; whether it is the divisor of 3/2x, which is (3/2)*x.
struct Run {
  Tree product;
  bool is_fraction;
};
/// The whole text as it is to be written, ": write a*b"; both readings of a/b c.
std::string advice(const Relation& relation, const std::vector<Run>& runs, const Symbols& symbols);
/// arcsin, ln: whether it is a function under that name in other languages.
bool is_function_elsewhere(std::string_view name);
/// What to say of a name that is no function, or no symbol; `quoted` is how it was typed.
std::string unknown_function(std::string_view name, const std::string& quoted);
std::string unknown_symbol(std::string_view name, const std::string& quoted, const Symbols& symbols);

}  // namespace rederive
