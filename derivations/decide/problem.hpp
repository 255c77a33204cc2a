// Two statements under assumptions, about symbols in ranges. No procedure decides all (Richardson 1968).
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>
#include <set>

namespace rederive::decide {

struct Problem {
  language::Relation left, right;               ///< expressions have one side and no operator
  std::vector<language::Relation> assumptions;  ///< sign conditions and equations, with two sides each
  language::Symbols symbols;
  std::map<std::string, language::Tree> values = {};  ///< symbol → what was put in for it, in other symbols
};

bool is_symbol(const language::Tree& tree);                                 ///< pi is not a symbol
bool is_equation(const language::Relation& r);                              ///< a = b = …
std::vector<language::Relation> links_of(const language::Relation& chain);  ///< of a = b < c: a = b and b < c
std::vector<language::Relation> equations_of(std::vector<language::Relation> relations);
/// Returns all trees of a problem.
std::vector<language::Tree> trees_of(const Problem& problem);

/// Return the names of the symbols that occur.
std::set<std::string> names_of(const language::Tree& tree);
std::set<std::string> names_of(const language::Relation& relation);

/// Returns the relation with `value` in place of a symbol.
language::Relation put_in(language::Relation relation, const std::string& symbol,
                          const language::Tree& value);

/// Return a + b*pi as a tree and as a coordinate.
language::Tree tree_of(const numbers::Constant& c);
numbers::Number number_of(const numbers::Constant& c);
language::Tree zero();
/// Returns a - b.
language::Tree difference(const language::Tree& a, const language::Tree& b);

/// Substitutes given values, and symbols that an assumed equation determines. The range of such a symbol, and
/// other assumptions about it, remain as sign conditions on its value.
Problem with_values(Problem problem, const std::vector<language::Given>& given);

/// Returns f(u) = v as u = g(v), if g inverts the monotone f and v is among the values of f: x = asin(u) says
/// sin(x) = u for -pi/2 <= x <= pi/2. Likewise for inequalities; f(u) = f(v) becomes u = v, and
/// u^2 = 0, |u| = 0, -2*u = 0 and cosh(u) = 1 become u = 0.
language::Relation with_inversions(const language::Relation& relation, const language::Symbols& symbols);

}  // namespace rederive::decide
