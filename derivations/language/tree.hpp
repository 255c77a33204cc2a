// The syntax tree of an expression: its form, as it was written.
#pragma once

#include <cln/integer.h>
#include <cln/integer_io.h>
#include <cln/rational.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rederive::language {

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

/// Returns a node with these parts. `inverse` has an entry for every child of a sum or a product.
inline Tree make_tree(Node::Kind kind, std::string text, std::vector<Tree> children = {},
                      std::vector<bool> inverse = {}, std::size_t position = 0) {
  return std::make_shared<const Node>(
      Node{kind, std::move(text), std::move(children), std::move(inverse), position});
}

/// Returns whether two trees have the same form; their positions do not matter.
inline bool is_same(const Tree& a, const Tree& b) {
  return a == b || (a->kind == b->kind && a->text == b->text && a->inverse == b->inverse &&
                    std::ranges::equal(a->children, b->children, is_same));
}

/// Returns the tree with `value` in place of every part that has the same form as `part`.
inline Tree put_in(const Tree& tree, const Tree& part, const Tree& value) {
  if (is_same(tree, part)) return value;
  std::vector<Tree> children;
  bool is_unchanged = true;
  for (const Tree& child : tree->children) {
    children.push_back(put_in(child, part, value));
    is_unchanged = is_unchanged && children.back() == child;
  }
  return is_unchanged ? tree : make_tree(tree->kind, tree->text, std::move(children), tree->inverse);
}
/// Returns the tree with `value` in place of a symbol.
inline Tree put_in(const Tree& tree, const std::string& symbol, const Tree& value) {
  return put_in(tree, make_tree(Node::Kind::symbol, symbol), value);
}

/// Returns the exact value of the text of a number node, which has digits, perhaps a point, perhaps an
/// exponent: 1/4 for "0.25". For any other text it returns some number, or throws std::invalid_argument or
/// std::out_of_range (because of the exponent) or cln::runtime_exception. The caller bounds the size.
inline cln::cl_RA exact(const std::string& number) {
  if (number.size() == 1 && number != ".") return number[0] - '0';
  const auto e = number.find_first_of("eE");
  std::string digits = number.substr(0, e);
  long power = e == std::string::npos ? 0 : std::stol(number.substr(e + 1));
  if (const auto point = digits.find('.'); point != std::string::npos) {
    power -= static_cast<long>(digits.size() - point - 1);
    digits.erase(point, 1);
  }
  return (digits.empty() ? cln::cl_I(0) : cln::cl_I(digits.c_str())) * cln::expt(cln::cl_RA(10), power);
}

/// A chain of relations: sides[0] operators[0] sides[1] …; the operators are =, <, <=, >, >=.
struct Relation {
  std::vector<Tree> sides;
  std::vector<std::string> operators;
};

/// Bounds on what is read. They are checked before anything expensive is done.
struct Limits {
  std::size_t characters = 10'000;
  std::size_t depth = 200;  ///< at most 500: the stack has no room for more
  std::size_t digits = 40;  ///< in one number, including its decimal exponent
  long exponent = 64;       ///< the largest integer exponent
};

/// Why a text cannot be read. From `symbol_not_given` on, only readers of answers to exercises find these.
// clang-format off
enum class Mistake {
  syntax, character, empty, unknown_symbol, unknown_function, arguments, implicit_multiplication, relation,
  too_long, too_deep, too_large, undefined, symbol_not_given, expression_wanted, equation_wanted,
  one_relation_wanted, value_wanted, number_wanted, not_real, unit, unit_not_wanted, unknown_unit,
  ambiguous_unit, decimal_comma, assumption
};
// clang-format on

/// A text that could not be read: the mistake and its place; what() says why and what would be right.
struct SyntaxError : std::runtime_error {
  SyntaxError(Mistake kind, std::size_t where, const std::string& message)
      : std::runtime_error(message), mistake(kind), position(where) {}
  Mistake mistake;
  std::size_t position;  ///< byte offset in the text
};

}  // namespace rederive::language
