// Two statements under assumptions, about symbols in ranges. No procedure decides all (Richardson 1968).
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>
#include <set>

namespace rederive {

struct Problem {
  Relation left, right;               ///< expressions have one side and no operator
  std::vector<Relation> assumptions;  ///< sign conditions and equations, with two sides each
  Symbols symbols;
  std::map<std::string, Tree> values = {};  ///< symbol → what was put in for it, in other symbols
};

bool is_symbol(const Tree& tree);                       ///< pi is not a symbol
bool is_equation(const Relation& r);                    ///< a = b = …
std::vector<Relation> links_of(const Relation& chain);  ///< of a = b < c: a = b and b < c
std::vector<Relation> equations_of(std::vector<Relation> relations);
/// Returns all trees of a problem.
std::vector<Tree> trees_of(const Problem& problem);

/// Return the names of the symbols that occur.
std::set<std::string> names_of(const Tree& tree);
std::set<std::string> names_of(const Relation& relation);

/// Returns the relation with `value` in place of a symbol.
Relation put_in(Relation relation, const std::string& symbol, const Tree& value);

/// Return a + b*pi as a tree and as a coordinate.
Tree tree_of(const Constant& c);
Number number_of(const Constant& c);
Tree zero();
/// Returns a - b.
Tree difference(const Tree& a, const Tree& b);

/// Substitutes given values, and symbols that an assumed equation determines. The range of such a symbol, and
/// other assumptions about it, remain as sign conditions on its value.
Problem with_values(Problem problem, const std::vector<Given>& given);

/// Returns f(u) = v as u = g(v), if g inverts the monotone f and v is among the values of f: x = asin(u) says
/// sin(x) = u for -pi/2 <= x <= pi/2. Likewise for inequalities; f(u) = f(v) becomes u = v, u^2 = 0 u = 0.
Relation with_inversions(const Relation& relation, const Symbols& symbols);

}  // namespace rederive
