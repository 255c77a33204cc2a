// The reactions while the block rocks, and the friction they need: (47) to (51), for both signs of θ.
#pragma once

#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive {

/// H/m and V/m at the pivot while rocking on that side: the acceleration of C, with θ̈ from (21).
/// In p, R, g, α, θ, θ̇, ü_g; H to the right and V upwards, on the block.
GiNaC::ex horizontal_reaction(Side side);
GiNaC::ex vertical_reaction(Side side);

Derivation equation_47a();
Derivation equation_47b();
Derivation equation_48a();
Derivation equation_48b();
Derivation equation_48c();
Derivation equation_49a();
Derivation equation_49b();
Derivation equation_49c();
Derivation equation_50a();
Derivation equation_50b();
Derivation equation_50();
Derivation equation_50c();
Derivation equation_51a();
Derivation equation_51b();
Derivation equation_51c();

/// Results of our own: the reactions that are right, and what friction must bear, on either side.
Derivation horizontal_reaction_negative();
Derivation vertical_reaction_negative();
Derivation friction_demand_negative();
Derivation horizontal_reaction_positive();
Derivation vertical_reaction_positive();
Derivation friction_demand_positive();
/// The block keeps in contact only while V > 0.
Derivation contact_negative();
Derivation contact_positive();

}  // namespace rederive
