// The energy of the rocking block, (22), and what it says of free motion.
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive {

/// E = K + Ω on either side: (22a), (22b). Conserved while the ground rests.
GiNaC::ex energy(Side side);
/// dE/dt along a motion that obeys (21) on that side; 0 where the ground rests.
GiNaC::ex energy_rate(Side side);

/// θ̇ with which free motion at θ just reaches θ = ∓α, by (22): ∓2 p sin((α ± θ)/2). The difference of
/// cosines is written as a product, in which nothing cancels for slender blocks and near θ = ∓α.
Derivation critical_rate(Side side);
/// θ̇² at the impact to which free motion leads from θ, θ̇, by (22), in the same manner.
Derivation impact_rate_squared(Side side);

/// E = K + Ω; the strain energy that the paper names V is none.
Derivation total_energy();
Derivation equation_22a();
Derivation equation_22b();
/// ü_g that holds the block at θ = α by (21a) and by (21b).
Derivation ground_at_alpha_by_21a();
Derivation ground_at_alpha_by_21b();

}  // namespace rederive
