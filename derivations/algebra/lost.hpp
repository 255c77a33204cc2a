// Solutions that are lost: one statement holds wherever something is 0 that the other one divides by.
#pragma once

#include <derivations/algebra/consequences.hpp>
#include <derivations/algebra/residuals.hpp>
#include <optional>
#include <vector>

namespace rederive {

/// What one statement divides by while the other one holds all along where that is 0, whatever the other
/// symbols are: (x^2 - 1)/(x - 1) = 2 has no solution, and x = 1 has one; x*sin(y)^2/sin(y) = 0
/// loses all of y = 0. It may have cancelled. Not of a strict one, nor what an assumption says is never 0.
/// A factor of the other residual is found as such, and taken to be 0 somewhere; what is none, by looking at
/// zeros of the divisor, of which some may not be found. Throws Undecidable.
std::optional<GiNaC::ex> lost_to(const Residuals& residuals, const Symbols& symbols);

/// What of these divisors may be 0, is not among the others, and is not what an assumption says is never 0.
std::vector<GiNaC::ex> own_divisors(const std::vector<GiNaC::ex>& divisors,
                                    const std::vector<GiNaC::ex>& others, const Symbols& symbols);

/// The same of a statement of several links: all of them, none strict, hold all along where one of these
/// divisors of the other statement is 0. Throws Undecidable.
std::optional<GiNaC::ex> lost_along(const std::vector<GiNaC::ex>& divisors, const std::vector<Asked>& links,
                                    const Symbols& symbols);

/// One of these divisors that is a factor of `left` or `right`, the residuals as they are compared; where
/// both are divided by it, neither has a value there, and nothing is lost.
std::optional<GiNaC::ex> losing_divisor(const std::vector<GiNaC::ex>& divisors, const Residuals& residuals,
                                        const GiNaC::ex& left, const GiNaC::ex& right,
                                        const Symbols& symbols);

}  // namespace rederive
