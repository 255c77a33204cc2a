// From energies to the equation of rocking, (1) and (5) to (21), and the same once more from moments.
#pragma once

#include <derivations/rocking_block/kinematics.hpp>

namespace rederive {

/// The block seen from the pivot on that side, at rest: x in (0, 2b) from O, in (−2b, 0) from O'; y in (0,
/// 2h).
Rectangle block_from_pivot(Side side);
/// The block seen from its centre.
Rectangle block_from_centre();

/// K of (6), (16): J_o θ̇²/2 + m u̇_g²/2 + m R u̇_g θ̇ cos(α ± θ), in J_o.
GiNaC::ex kinetic_energy(Side side);
/// Ω of (9), (14).
GiNaC::ex weight_potential(Side side);
/// The terms of (1) on either side: (7a), (7b), (8), (10).
LagrangeTerms block_lagrange_terms(Side side);
/// J_o θ̈ + … of (11), (20): vanishes in every motion. By Lagrange.
GiNaC::ex motion_by_lagrange(Side side);
/// The same by the moments of all elements about the pivot; in b, h and m.
GiNaC::ex motion_by_moments(Side side);
/// θ̈ of (21a), (21b), solved; in p, α, θ, ü_g and g.
GiNaC::ex angular_acceleration(Side side);

Derivation equation_1();
Derivation moment_of_inertia_about_centre();
Derivation parallel_axis();
Derivation moment_of_inertia_about_pivot();
Derivation moment_of_inertia_about_other_pivot();
Derivation frequency_parameter();
Derivation equation_5();
Derivation equation_6();
Derivation equation_7a();
Derivation equation_7b();
Derivation equation_8();
Derivation equation_9();
Derivation equation_10();
Derivation equation_11();
Derivation equation_14();
Derivation equation_16a();
Derivation equation_16b();
Derivation equation_17a();
Derivation equation_17b();
Derivation equation_18();
Derivation equation_19();
Derivation equation_20();
Derivation equation_21a();
Derivation equation_21b();

}  // namespace rederive
