// A sum as a list of terms and a product as a list of factors: between GiNaC's expressions and our trees.
#pragma once

#include <ginac/ginac.h>

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <string>
#include <vector>

namespace rederive {

struct Term;

/// base^exponent in a product; the exponent is a number wherever it can be.
struct Factor {
  Tree base;  ///< of a sum, the tree before any turning: it decides the order
  GiNaC::numeric exponent = 1;
  Tree symbolic = nullptr;       ///< the exponent where it is no number
  std::vector<Term> parts = {};  ///< the terms of a sum that is turned so that asks_to_turn(parts) is false
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

/// Whether the sum has more minus than plus signs, or as many and begins with a minus (or has one before its
/// pi): of a sum and its negative, one does.
bool asks_to_turn(const std::vector<Term>& parts);
/// Changes the sign of every term.
void turn(std::vector<Term>& parts);

/// `present`: sums inside are turned where that saves a minus, -x*(y - z) being x*(z - y).
Tree sum_tree(std::vector<Term> parts, bool present);
/// Of the term without its sign: 3*g/(4*R), 1/2*m*R^2, pi/2.
Tree product_tree(const Term& term, bool present);
/// With its sign.
Tree term_tree(const Term& term, bool present);

}  // namespace rederive
