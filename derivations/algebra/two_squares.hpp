// Sums of two squares in several symbols, as the denominator of a resonance: (1 - r^2)^2 + 4 zeta^2 r^2.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>

namespace rederive {

/// A polynomial in several symbols that is positive over the declared ranges, so written that its range shows
/// it: a y² + k s² with a square k s² in the other symbols and a y² > 0; or, for a y² + k s² = k (A t² + s²)
/// with A > 0 and polynomials s and t in one symbol that are never 0 together,
///   k (A + (u s - v A t)²)/(u² + A v²), where u t + v s = 1.
/// Nothing for any other polynomial.
std::optional<GiNaC::ex> form_of_two_squares(const GiNaC::ex& polynomial, const Symbols& symbols);

}  // namespace rederive
