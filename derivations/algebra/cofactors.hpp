// Equations solved one after another, as at the blackboard, with account kept of what becomes of them.
#pragma once

#include <derivations/algebra/consequences.hpp>

namespace rederive {

/// The target as a sum of the equations with factors, and `more`: each equation in turn is freed from what
/// divides it, solved for a symbol in which it is linear, with a slope that is never 0, and put into the
/// others and the target. Never 0 are `divisors`, and what has one sign over the declared ranges. Not looked
/// over: `shows` does that.
std::optional<Consequence> by_elimination(const Asked& target, const std::vector<Asked>& links,
                                          const std::vector<GiNaC::ex>& divisors, const Symbols& symbols);

/// Whether a product has no factor that may be 0; the divisors are not. Throws Undecidable.
bool is_never_zero(const GiNaC::ex& product, const std::vector<GiNaC::ex>& divisors, const Symbols& symbols);

/// Whether a symbol cannot be 0 where all the links hold: with 0 for it, one of the equations never does.
bool exclude_zero(const std::vector<Asked>& links, const GiNaC::ex& symbol, const Symbols& symbols);

}  // namespace rederive
