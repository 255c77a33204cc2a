// The condition for rocking to begin, and for beginning without sliding: (23) to (33).
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive {

/// ü_g at which a block at rest begins to rock, (24): g tan α.
GiNaC::ex acceleration_that_suffices();
/// θ̈(0) of (28) from rest under ü_g(0) = λ α_p > g tan α, in R, g, α, λ, a_p: from (25) to (27).
GiNaC::ex first_angular_acceleration();
/// H(0)/V(0) of (31), with that angular acceleration.
GiNaC::ex first_friction_demand();

Derivation equation_23();
Derivation force_before_rocking();
Derivation force_at_peak();
Derivation equation_24a();
Derivation equation_24b();
Derivation equation_25a();
Derivation equation_25b();
Derivation equation_26a();
Derivation equation_26b();
Derivation equation_27();
Derivation share_at_most_one();
Derivation share_at_least();
Derivation equation_28a();
Derivation equation_28b();
Derivation equation_30();
Derivation equation_31();
Derivation start_of_gradual_pulse();
Derivation first_acceleration();
Derivation equation_32a();
Derivation equation_32b();
/// b/h, from where the centre is at rest.
GiNaC::ex slope_of_diagonal();
Derivation equation_33();

}  // namespace rederive
