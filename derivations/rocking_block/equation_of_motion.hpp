// From energies to the equation of rocking, (1) and (5) to (21), and the same once more from moments.
#pragma once

#include <derivations/rocking_block/kinematics.hpp>

namespace rederive::rocking_block {

/// Returns the block at rest, seen from the pivot on that side: x is in (0, 2b) from O and in (−2b, 0) from
/// O', y is in (0, 2h).
mechanics::RigidBody block_from_pivot(Side side);

/// Returns J_o = 4/3 m R² and R = 3g/(4p²) in m, g and p. With these (11) and (20) become (21).
std::vector<language::Given> inertia_and_frequency();

/// Returns the kinetic energy of (6) or (16), J_o θ̇²/2 + m u̇_g²/2 + m R u̇_g θ̇ cos(α ± θ).
GiNaC::ex kinetic_energy(Side side);
/// Returns the potential Ω of (9) or (14).
GiNaC::ex weight_potential(Side side);
/// Returns the left side J_o θ̈ + … of (11) or (20), which is 0 in every motion, by Lagrange's equation.
GiNaC::ex motion_by_lagrange(Side side);
/// Returns the same by the moments of all elements about the pivot, in b, h and m.
GiNaC::ex motion_by_moments(Side side);
/// Returns θ̈ by (21a) or (21b), in p, α, θ, ü_g and g.
GiNaC::ex angular_acceleration(Side side);

/// Derive J_c of (5), J_o of (6) and p of (21) for a homogeneous rectangle.
mechanics::Derivation moment_of_inertia_about_centre();
mechanics::Derivation moment_of_inertia_about_pivot();
mechanics::Derivation frequency_parameter();

/// Adds the derivations of (1), (5) to (11), (14), (16) to (21).
void derive_equation_of_motion(paper::Derivations& rows);

}  // namespace rederive::rocking_block
