// A sum as a list of terms and a product as a list of factors: between GiNaC's expressions and our trees.
#pragma once

#include <ginac/ginac.h>

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <vector>

namespace rederive {

struct Term;

/// base^exponent in a product; the exponent is a number wherever it can be.
struct Factor {
  Tree base;
  GiNaC::numeric exponent = 1;
  Tree symbolic = nullptr;       ///< the exponent where it is no number
  std::vector<Term> parts = {};  ///< the terms of a sum
};

/// coefficient * factors[0] * factors[1] …, the factors in order.
struct Term {
  GiNaC::numeric coefficient = 1;
  std::vector<Factor> factors;
  bool transcendental = false;  ///< has a function in it
};

/// The order in which a person writes terms and factors. It follows the table of symbols and nothing else.
/// Terms without functions first; then as in a dictionary, by the powers of the symbols, the highest first.
bool is_before(const Term& a, const Term& b, const Symbols& symbols);
/// Numbers, symbols, roots and powers, functions, sums: the simple before the complicated.
bool is_before(const Factor& a, const Factor& b, const Symbols& symbols);

/// Changes the sign of every term, and says so, if more of them have a minus than a plus sign, or as many and
/// the first (or its pi) has a minus: of a sum and its negative, one is turned.
bool turn_if_negative(std::vector<Term>& sum);

/// 3*g/(4*R), 1/2*m*R^2, pi/2, y - x. Sums inside are turned where that saves a minus, -x*(y - z) being x*(z
/// - y).
Tree sum_tree(std::vector<Term> sum);

}  // namespace rederive
