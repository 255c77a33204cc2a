// From energies to the equation of rocking, (1) and (5) to (21), and the same once more from moments.
#pragma once

#include <derivations/rocking_block/kinematics.hpp>

namespace rederive::rocking_block {

/// The block seen from the pivot on that side, at rest: x in (0, 2b) from O, in (−2b, 0) from O'; y in (0,
/// 2h).
Rectangle block_from_pivot(Side side);

/// J_o = 4/3 m R² and R = 3g/(4p²), both in terms of m, g, p: what turns (11), (20) into (21).
std::vector<Given> inertia_and_frequency();

/// K of (6), (16): J_o θ̇²/2 + m u̇_g²/2 + m R u̇_g θ̇ cos(α ± θ), in J_o.
GiNaC::ex kinetic_energy(Side side);
/// Ω of (9), (14).
GiNaC::ex weight_potential(Side side);
/// J_o θ̈ + … of (11), (20): vanishes in every motion. By Lagrange.
GiNaC::ex motion_by_lagrange(Side side);
/// The same by the moments of all elements about the pivot; in b, h and m.
GiNaC::ex motion_by_moments(Side side);
/// θ̈ of (21a), (21b), solved; in p, α, θ, ü_g and g.
GiNaC::ex angular_acceleration(Side side);

Derivation moment_of_inertia_about_centre();
Derivation moment_of_inertia_about_pivot();
Derivation moment_of_inertia_about_other_pivot();
Derivation frequency_parameter();
Derivation equation_6();
Derivation equation_9();
Derivation equation_11();
Derivation equation_14();
Derivation equation_16b();
Derivation equation_21a();
Derivation equation_21b();

/// (1), (5) to (11), (14), (16) to (21).
Derivations derivations_of_equation_of_motion();

}  // namespace rederive::rocking_block
