// The condition for rocking to begin, and for beginning without sliding: (23) to (33).
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive::rocking_block {

/// Returns the ground acceleration ü_g at which a block at rest begins to rock, g tan α of (24).
GiNaC::ex acceleration_that_suffices();
/// Returns θ̈(0) of (28) from rest under ü_g(0) = λ α_p > g tan α, in R, g, α, λ and a_p, from (25) to (27).
GiNaC::ex first_angular_acceleration();
/// Returns H(0)/V(0) of (31) with that angular acceleration.
GiNaC::ex first_friction_demand();

/// Returns b/h by the position of the centre of mass at rest.
GiNaC::ex slope_of_diagonal();

/// Derives ü_g(0) = g tan α for a ground acceleration that grows from zero.
mechanics::Derivation first_acceleration();

/// Adds the derivations of (23) to (33).
void derive_initiation(paper::Derivations& rows);

}  // namespace rederive::rocking_block
