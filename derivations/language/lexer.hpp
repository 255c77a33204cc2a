// Splits a text into tokens and checks the bounds of what is read.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rederive::language {

struct Token {
  enum class Kind {
    number,       ///< digits as written
    name,         ///< in ASCII; it need not be known
    superscript,  ///< an integer exponent: "2", "-1"
    mark,         ///< + - * / ^ ( ) , and "sqrt" for √
    relation,     ///< = < <= > >=
    end
  };
  Kind kind;
  std::string text;
  std::size_t position, end;  ///< bytes

  /// Returns whether this is the given mark. The mark "sqrt" is √; the typed name sqrt is not a mark.
  bool is(std::string_view mark) const { return kind == Kind::mark && text == mark; }
  bool starts_operand() const { return kind == Kind::number || kind == Kind::name || is("(") || is("sqrt"); }
};

/// Returns the tokens of a text; the last one is the end. A name that is not known, but consists of known
/// names, becomes these: mgR becomes three. Pi is read as pi; other look-alikes throw. Throws SyntaxError.
std::vector<Token> tokenize(std::string_view text, const Symbols& symbols, const Limits& limits);

/// Returns the known words of which a name consists, at most three: {"m", "g", "R"} for mgR, {"sin", "2",
/// "x"} for sin2x. Returns the name alone if it is known, or if it looks like a misspelt word; a name of at
/// most three typed characters, such as αp, never does.
std::vector<std::string> words_in(const std::string& name, std::size_t characters, const Symbols& symbols);
/// Returns our name of a function that has another name elsewhere: "asin" for "arcsin"; "" for other words.
std::string function_elsewhere(std::string_view name);
/// Returns the message for an unknown function or symbol; `quoted` is the name as it was typed.
std::string unknown_function(std::string_view name, const std::string& quoted);
std::string unknown_symbol(std::string_view name, const std::string& quoted, const Symbols& symbols);

}  // namespace rederive::language
