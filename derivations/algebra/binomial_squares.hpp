// Sums of squares of two terms each, as in x^3 + y^3 + z^3 - 3 x y z = ((x-y)^2 + (y-z)^2 + (z-x)^2)
// (x+y+z)/2: what stands behind the inequalities of means.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>

namespace rederive {

/// A polynomial in two to four symbols or functions, or their square roots, that keeps one sign over the
/// declared ranges, so written that its range shows it: a sum of c m (u - r v)² and d m b with positive
/// numbers c and d, a small number r, monomials u and v, monomials m of which no factor may be negative, and
/// b = 1 or one bound or two that a range has, as 1 - sin x; with sin²x + cos²x for 1, and cosh²x - sinh²x;
/// or such a sum of squares over a power of the sum of the symbols (and 1), as Pólya has it. The numbers are
/// found by a linear program; as much as possible is left to the terms d m, so that what is never 0 is seen
/// to be. Nothing for any other polynomial, and for one with more than a few terms.
std::optional<GiNaC::ex> form_of_binomial_squares(const GiNaC::ex& polynomial, const Symbols& symbols);

}  // namespace rederive
