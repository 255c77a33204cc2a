// Is this expression identically zero? The heart of prove.
#pragma once

#include <derivations/algebra/phases.hpp>
#include <optional>

namespace rederive {

/// True only if `expression` vanishes wherever it is defined inside the declared ranges. Throws Undecidable
/// where it is outside the class. False says only that it was not shown to vanish.
bool vanishes(const GiNaC::ex& expression, const Symbols& symbols);

/// For a numerator b·r - a, where r is a root or an absolute value of degree n, bⁿrⁿ = aⁿ in the ring, and
/// for even n the signs of a and b agree, all over the declared ranges: the numerator is 0 wherever it is
/// defined. Gives (bⁿrⁿ - aⁿ)/(b·r - a).
std::optional<GiNaC::ex> cofactor_of_powers(const GiNaC::ex& numerator, const Phases& phases,
                                            const Symbols& symbols);

/// Why a reduced polynomial in generators vanishes: a polynomial c, not identically 0, with numerator·c = 0
/// modulo the relations; c is 1 where the numerator is 0. Over the declared ranges both are analytic, so that
/// one of them is 0.
std::optional<GiNaC::ex> cofactor(const GiNaC::ex& numerator, const Phases& phases, const Symbols& symbols);

/// The box of declared ranges without its edges, cut at x = 0 for every |x| in it, if the expression is
/// analytic on all pieces, so that it has a value there; at their edges it is continuous where it has a
/// value. Empty if that is no other box.
std::vector<Symbols> analytic_pieces(const GiNaC::ex& expression, const Symbols& symbols);

/// Why an expression vanishes that has no cofactor: a factor of it, a sum of inverse functions that is 0
/// because its exponential is 1.
std::optional<GiNaC::ex> vanishing_sum(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive
