// Text → a small tree that keeps the form as written → a GiNaC expression.
//
// The grammar:
//
//   statement = sum { relation sum }
//   sum       = ["+"|"-"] product { ("+"|"-") product }
//   product   = factor { ("*"|"/") factor }
//   factor    = ("+"|"-") factor | power
//   power     = primary [ superscript | "^" exponent ]
//   exponent  = ("+"|"-") exponent | power
//   primary   = number | name | function [superscript] "(" sum {"," sum} ")" | "(" sum ")" | "√" primary
//
// So -a*b is -(a*b), -x^2 is -(x^2), a/b*c is (a/b)*c, a^b^c is a^(b^c), and √x² is (√x)². A relation is =,
// <, <=, > or >=. A name is a declared symbol, or pi, which is π. Functions are those of C (sin, asin, sinh,
// sqrt, exp, log, fabs …), abs, cot, sec, csc, coth, sech and csch, of one argument each; pow(a, b) is a^b,
// and sin²(x) is sin(x)^2. Greek letters, dots over letters, superscripts, √, ·, ×, −, ≤ and ≥ may be typed
// in Unicode. Decimal numbers are exact rationals.
//
// No implicit multiplication: 2x, x(y + z) and sin x are refused, with what is to be written instead. So are
// sin⁻¹(x), which may mean two things, and x²^3.
#pragma once

#include <cln/rational.h>

#include <cstddef>
#include <derivations/algebra/symbols.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rederive {

struct Node;
using Tree = std::shared_ptr<const Node>;

/// One node of an expression as it was written. Immutable once built.
struct Node {
  enum class Kind {
    number,    ///< text: digits as written, "3", "0.25", "1e-3"; never negative
    symbol,    ///< text: its ASCII name; "pi" is the constant π
    negative,  ///< -children[0]
    sum,       ///< children[0] ± children[1] ± …; inverse[i] marks a subtracted term
    product,   ///< children[0] *or/ children[1] …; inverse[i] marks a divisor
    power,     ///< children[0] ^ children[1]
    call       ///< text(children…)
  };
  Kind kind;
  std::string text;
  std::vector<Tree> children;
  std::vector<bool> inverse;
  std::size_t position = 0;  ///< byte offset in the text that was parsed
};

/// A chain of relations: sides[0] operators[0] sides[1] …; the operators are =, <, <=, >, >=.
struct Relation {
  std::vector<Tree> sides;
  std::vector<std::string> operators;
};

/// Bounds on what is read, checked before anything expensive is done. What decides, as prove(), lowers trees
/// with the bounds as they are here.
struct Limits {
  std::size_t characters = 10'000;
  std::size_t depth = 200;  ///< not beyond 500, whatever is asked: the stack bears no more
  std::size_t digits = 40;  ///< in one number, its decimal exponent included
  long exponent = 64;       ///< the largest integer exponent
};

/// A text that could not be read: a stable word for it, where, why, and what would be right.
struct SyntaxError : std::runtime_error {
  /// `note` is one of the words below, `message` a sentence that what() gives.
  SyntaxError(std::string note, std::size_t position, const std::string& message);
  /// "syntax", "character", "empty", "unknown_symbol", "unknown_function", "arguments",
  /// "implicit_multiplication", "relation", "too_long", "too_deep", "too_large", "undefined"
  std::string note;
  std::size_t position;  ///< byte offset in the text
};

/// The message, the line and a caret under the character at fault: three lines for a terminal.
std::string explain(const SyntaxError& error, std::string_view text);

/// Reads one expression. Names that `symbols` does not have are refused with the nearest known one, here and
/// below. Throws SyntaxError, "relation" where the text is a relation.
Tree parse(std::string_view text, const Symbols& symbols = paper_symbols(), const Limits& limits = {});
/// Reads a relation or a chain of them ("K = a = b"); at least one operator. Throws SyntaxError, "relation"
/// where there is none.
Relation parse_relation(std::string_view text, const Symbols& symbols = paper_symbols(), const Limits& = {});
/// Reads either: an expression comes back as a Relation with one side and no operator. Throws SyntaxError.
Relation parse_statement(std::string_view text, const Symbols& symbols = paper_symbols(), const Limits& = {});

/// The GiNaC expression a tree stands for. GiNaC simplifies as it builds: ask the tree about form.
/// Throws SyntaxError "undefined" where there is no real value at once (1/0, log(0), sqrt(-1)), "too_large"
/// where a power would make a number of more digits than anybody wants.
GiNaC::ex lower(const Tree& tree, const Symbols& symbols = paper_symbols(), const Limits& limits = {});

/// The exact value of a number as written: "0.25" is 1/4, "1e-3" is 1/1000. It must be the text of a number
/// node: digits, perhaps with a point, perhaps with an exponent. Limits bound its size in parse(), not here.
/// Of any other text it may give some number, or throw std::invalid_argument, std::out_of_range (both of the
/// exponent) or cln::runtime_exception.
cln::cl_RA exact(const std::string& number);

}  // namespace rederive
