// Is this expression identically zero? The heart of prove.
#pragma once

#include <derivations/algebra/phases.hpp>
#include <optional>

namespace rederive {

/// True only if `expression` vanishes wherever it is defined inside the declared ranges. Throws Undecidable
/// where it is outside the class. False says only that it was not shown to vanish.
bool vanishes(const GiNaC::ex& expression, const Symbols& symbols);

/// For a numerator b·r - a, where r is a root or an absolute value of degree n, bⁿrⁿ = aⁿ in the ring, and for even n
/// the signs of a and b agree, all over the declared ranges: the numerator is 0 wherever it is defined. Gives (bⁿrⁿ - aⁿ)/(b·r - a).
std::optional<GiNaC::ex> cofactor_of_powers(const GiNaC::ex& numerator, const Phases& phases, const Symbols& symbols);

}  // namespace rederive
