// Roots, logarithms and arcs of constants in one form each.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>
#include <string>

namespace rederive {

/// value^q for a positive rational value, as a product of powers of primes; large cofactors stay whole.
GiNaC::ex number_root(const GiNaC::numeric& value, const GiNaC::numeric& q);
/// The square root of a sum of a rational number and a square root, if that is a sum of two square roots:
/// 1 + √2 for 3 + 2√2; else 0.
GiNaC::ex denested_root(const GiNaC::ex& sum);
/// Its logarithm, as a sum of those of primes.
GiNaC::ex number_logarithm(const GiNaC::numeric& value);

/// asin, acos or atan of a constant as a multiple of π, if its sine, cosine or tangent is proved to be that.
std::optional<GiNaC::numeric> turn_of(const std::string& function, const GiNaC::ex& of,
                                      const Symbols& symbols);

}  // namespace rederive
