// The energy of the rocking block, (22), and what it says of free motion.
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive::rocking_block {

/// Returns the energy E = K + Ω of (22a) or (22b). It is constant while the ground is at rest.
GiNaC::ex energy(Side side);
/// Returns dE/dt along a motion that obeys (21) on that side. It is 0 while the ground is at rest.
GiNaC::ex energy_rate(Side side);

/// Derives the velocity θ̇ with which free motion at θ just reaches θ = ∓α, by (22): ∓2 p sin((α ± θ)/2). The
/// difference of cosines is written as a product, in which nothing cancels for slender blocks and near θ =
/// ∓α.
mechanics::Derivation critical_rate(Side side);
/// Derives the square θ̇² of the velocity at the impact to which free motion leads from θ and θ̇, by (22), in
/// the same form.
mechanics::Derivation impact_rate_squared(Side side);

/// Adds the derivations of (22) and of the ground acceleration at θ = α, by (21).
void derive_energy(paper::Derivations& rows);

}  // namespace rederive::rocking_block
