// The impact, (34) to (46): what the angular momentum about the new pivot leaves of the angular velocity.
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive {

/// The angular momentum about O' of the block that still turns about O with θ̇₋, at θ = 0: by integration.
GiNaC::ex momentum_before_impact();
/// And of the block that already turns about O' with θ̇₊.
GiNaC::ex momentum_after_impact();
/// The angular momentum before the impact once more: of the centre, and about the centre (parallel axes).
GiNaC::ex momentum_before_impact_by_centre();
/// e = θ̇₊/θ̇₋ of (46), in α alone; by integration and by the parallel axes.
GiNaC::ex restitution();
GiNaC::ex restitution_by_parallel_axes();

Derivation energy_loss_by_inertia();
Derivation energy_loss();
Derivation equation_35();
Derivation mass_of_the_block();
Derivation equation_37a();
Derivation equation_37b();
Derivation equation_38();
Derivation mass_element();
Derivation distance_from_pivot();
Derivation equation_39();
Derivation equation_39_width();
Derivation equation_39_height();
Derivation equation_40a();
Derivation equation_40b();
Derivation equation_41();
Derivation equation_42a();
Derivation equation_42b();
Derivation equation_43a();
Derivation equation_43b();
Derivation equation_45a();
Derivation equation_45b();
Derivation equation_46a();
Derivation equation_46b();

/// A result of our own: e if the impact acts at the distance d from O' on the base instead of at O' itself;
/// it grows from (46) at d = 0 to 1 at d = b.
Derivation restitution_of_spread_impact();

}  // namespace rederive
