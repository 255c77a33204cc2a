// What can be proved about expressions in real symbols without numbers: that they vanish, and their sign.
#pragma once

#include <derivations/language/symbols.hpp>
#include <optional>
#include <vector>

namespace rederive::mechanics {

/// Relations that hold, as GiNaC writes them: zeta < 1, k > 0, delta == omega_0. An expression without a
/// sign of relation is positive.
using Relations = std::vector<GiNaC::ex>;

/// Returns what the declared ranges say: x > 0 and x < L for a range (0, L). Throws SyntaxError for an end
/// that cannot be read.
Relations relations_of_ranges(const language::Symbols& symbols);

/// Returns the expression with 1 − cos² in place of every sin², and cosh² − 1 in place of every sinh²,
/// expanded.
GiNaC::ex by_pythagoras(const GiNaC::ex& e);

/// Returns e as one quotient, shorter by sin² + cos² = 1 and cosh² − sinh² = 1 where that is possible.
GiNaC::ex simplified(const GiNaC::ex& e);

/// Returns whether e vanishes wherever the equations of `known` hold. It decides this for rational functions
/// of symbols, square roots, sines and cosines; other identities it may miss.
bool vanishes(const GiNaC::ex& e, const Relations& known = {});

/// Returns −1, 0 or 1, the sign of e wherever it has a value and `known` holds, or nothing if the sign
/// changes or is not found. It looks at factors, at sums whose terms have one sign, at squares and at
/// functions of one sign, and at e less a multiple of a relation.
std::optional<int> sign(const GiNaC::ex& e, const Relations& known = {});

/// Returns e in our syntax, with symbols by their names.
std::string text_of(const GiNaC::ex& e);

/// Returns the factors of a polynomial in symbols, roots and functions over the rational numbers, with their
/// powers, in the order of their texts.
std::vector<GiNaC::ex> factors_of(const GiNaC::ex& e);

/// Returns the factors of e that may vanish, as far as `sign` knows, each with the sign that reads best.
std::vector<GiNaC::ex> factors_that_may_vanish(const GiNaC::ex& e, const Relations& known = {});

/// Returns the square root of `square`, which is not negative, with squares of factors taken out.
GiNaC::ex root_of(const GiNaC::ex& square, const Relations& known = {});

}  // namespace rederive::mechanics
