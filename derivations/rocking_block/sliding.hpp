// The reactions while the block rocks, and the friction they need: (47) to (51), for both signs of θ.
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive::rocking_block {

/// H/m and V/m at the pivot while rocking on that side: the acceleration of C, with θ̈ from (21).
/// In p, R, g, α, θ, θ̇, ü_g; H to the right and V upwards, on the block.
GiNaC::ex horizontal_reaction(Side side);
GiNaC::ex vertical_reaction(Side side);

/// (47) to (51), and results of our own.
Derivations derivations_of_sliding();

}  // namespace rederive::rocking_block
