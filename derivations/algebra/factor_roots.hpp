// Looks for a point at which a factor of an expression is 0.
#pragma once

#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>

namespace rederive {

/// What a product is made of, powers and divisors left away: the irreducible polynomials in its symbols and
/// functions, of which it is 0 where it has a value and one of them is 0. Those without symbols are left out.
std::vector<GiNaC::ex> factors_of(const GiNaC::ex& expression, const Symbols& symbols);

/// A zero that `wanted` accepts of a factor that `other` does not have: the factor alone is looked at, and
/// whether it changes its sign there or touches 0. Nothing for what is no product.
std::optional<Root> find_root_of_factor(const Written& expression, const GiNaC::ex& other,
                                        const Points& points, const Symbols& symbols,
                                        const std::function<bool(const Root&)>& wanted);

}  // namespace rederive
