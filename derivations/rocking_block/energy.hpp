// The energy of the rocking block, (22), and what it says of free motion.
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive::rocking_block {

/// E = K + Ω on either side: (22a), (22b). Conserved while the ground rests.
GiNaC::ex energy(Side side);
/// dE/dt along a motion that obeys (21) on that side; 0 where the ground rests.
GiNaC::ex energy_rate(Side side);

/// θ̇ with which free motion at θ just reaches θ = ∓α, by (22): ∓2 p sin((α ± θ)/2). The difference of
/// cosines is written as a product, in which nothing cancels for slender blocks and near θ = ∓α.
Derivation critical_rate(Side side);
/// θ̇² at the impact to which free motion leads from θ, θ̇, by (22), in the same manner.
Derivation impact_rate_squared(Side side);

/// (22), and the ground acceleration at θ = α by (21).
Derivations derivations_of_energy();

}  // namespace rederive::rocking_block
