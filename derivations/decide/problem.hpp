// Two statements under assumptions, about symbols in ranges. With sines none decides all (Richardson 1968).
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>
#include <set>

namespace rederive {

struct Problem {
  Relation left, right;               ///< expressions have one side and no operator
  std::vector<Relation> assumptions;  ///< sign conditions and equations that hold, of two sides each
  Symbols symbols;
  std::map<std::string, Tree> values = {};  ///< what was put in for a symbol, in the others
};

bool is_symbol(const Tree& tree);                       ///< pi is none
bool is_equation(const Relation& r);                    ///< a = b = …
std::vector<Relation> links_of(const Relation& chain);  ///< a = b < c: a = b and b < c
std::vector<Relation> equations_of(std::vector<Relation> relations);
/// All that stands in a problem.
std::vector<Tree> trees_of(const Problem& problem);

/// The names that occur.
std::set<std::string> names_of(const Tree& tree);
std::set<std::string> names_of(const Relation& relation);

/// The relation with a value in the place of a symbol.
Relation put_in(Relation relation, const std::string& symbol, const Tree& value);

/// a + b*pi as a tree, and as a coordinate.
Tree tree_of(const Constant& c);
Number number_of(const Constant& c);
Tree zero();
/// a - b.
Tree difference(const Tree& a, const Tree& b);

/// Puts in what is given and what equations among the assumptions say a symbol is. The range of the symbol,
/// and what else is assumed of it, stays as a sign condition on its value.
Problem with_values(Problem problem, const std::vector<Given>& given);

/// f(u) = v as u = g(v), for the inversion g of a monotone function f, where v lies in the values of f: x =
/// asin(u) says sin(x) = u where -pi/2 <= x <= pi/2. So inequalities; f(u) = f(v) as u = v; u^2 = 0 as u = 0.
Relation with_inversions(const Relation& relation, const Symbols& symbols);

}  // namespace rederive
