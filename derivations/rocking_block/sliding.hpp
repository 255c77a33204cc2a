// The reactions while the block rocks, and the friction that they need: (47) to (51), for both signs of θ.
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive::rocking_block {

/// Return H/m and V/m at the pivot while the block rocks on that side: the acceleration of C, with θ̈ from
/// (21), in p, R, g, α, θ, θ̇ and ü_g. H acts on the block to the right and V upwards.
GiNaC::ex horizontal_reaction(Side side);
GiNaC::ex vertical_reaction(Side side);

/// Adds the derivations of (47) to (51), and results of our own.
void derive_sliding(paper::Derivations& rows);

}  // namespace rederive::rocking_block
