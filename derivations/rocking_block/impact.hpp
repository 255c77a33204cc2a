// The impact, (34) to (46): what the angular momentum about the new pivot leaves of the angular velocity.
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive::rocking_block {

/// Returns the angular momentum about O' of the block that still turns about O with θ̇₋, at θ = 0, by
/// integration over the block.
GiNaC::ex momentum_before_impact();
/// Returns the angular momentum about O' of the block that already turns about O' with θ̇₊.
GiNaC::ex momentum_after_impact();
/// Returns the angular momentum before the impact by another method: the momentum of the centre of mass plus
/// the momentum about it.
GiNaC::ex momentum_before_impact_by_centre();
/// Return the restitution e = θ̇₊/θ̇₋ of (46), in α alone, by integration and by the parallel-axis theorem.
GiNaC::ex restitution();
GiNaC::ex restitution_by_parallel_axes();

/// Adds the derivations of (35) to (46), and of a result of our own.
void derive_impact(paper::Derivations& rows);

}  // namespace rederive::rocking_block
