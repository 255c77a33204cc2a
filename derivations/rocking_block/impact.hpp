// The impact, (34) to (46): what the angular momentum about the new pivot leaves of the angular velocity.
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive::rocking_block {

/// The angular momentum about O' of the block that still turns about O with θ̇₋, at θ = 0: by integration.
GiNaC::ex momentum_before_impact();
/// And of the block that already turns about O' with θ̇₊.
GiNaC::ex momentum_after_impact();
/// The angular momentum before the impact once more: of the centre, and about the centre (parallel axes).
GiNaC::ex momentum_before_impact_by_centre();
/// e = θ̇₊/θ̇₋ of (46), in α alone; by integration and by the parallel axes.
GiNaC::ex restitution();
GiNaC::ex restitution_by_parallel_axes();

Derivation energy_loss();
Derivation equation_35();

/// A result of our own: e if the impact acts at the distance d from O' on the base instead of at O' itself;
/// it grows from (46) at d = 0 to 1 at d = b.
Derivation restitution_of_spread_impact();

/// (35) to (46).
Derivations derivations_of_impact();

}  // namespace rederive::rocking_block
