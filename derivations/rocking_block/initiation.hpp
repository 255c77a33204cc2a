// The condition for rocking to begin, and for beginning without sliding: (23) to (33).
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive::rocking_block {

/// ü_g at which a block at rest begins to rock, (24): g tan α.
GiNaC::ex acceleration_that_suffices();
/// θ̈(0) of (28) from rest under ü_g(0) = λ α_p > g tan α, in R, g, α, λ, a_p: from (25) to (27).
GiNaC::ex first_angular_acceleration();
/// H(0)/V(0) of (31), with that angular acceleration.
GiNaC::ex first_friction_demand();

/// b/h, from where the centre is at rest.
GiNaC::ex slope_of_diagonal();

/// ü_g(0) = g tan α, where the ground acceleration grows from zero.
Derivation first_acceleration();
Derivation equation_32b();

/// (23) to (33).
Derivations derivations_of_initiation();

}  // namespace rederive::rocking_block
