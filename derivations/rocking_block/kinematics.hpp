// The position and the motion of the centre of mass C: (2) to (4) for θ < 0 about O, and (12), (13) and (15)
// for θ > 0 about O'.
#pragma once

#include <derivations/mechanics/plane.hpp>
#include <derivations/paper/derivations.hpp>
#include <derivations/paper/steps.hpp>
#include <emitted/rocking_block_symbols.hpp>

namespace rederive::rocking_block {

/// The side on which the block rocks: θ < 0 about O (Fig. 2a), θ > 0 about O' (Fig. 2b).
enum class Side { negative, positive };

/// Returns the rates along any motion of block and ground: θ → θ̇ → θ̈ and u_g → u̇_g → ü_g.
mechanics::Rates block_rates();
/// Returns b = R sin α and h = R cos α.
std::vector<language::Given> sides_of_the_block();

/// Returns C as seen from the pivot, at distance R and inclined by α ± θ, to the right of O or to the left of
/// O'.
mechanics::Vector centre_from_pivot(Side side);
/// Returns the displacement of C relative to the ground since rest.
mechanics::Vector centre_displacement(Side side);
/// Returns the velocity of C; the pivot moves with the ground.
mechanics::Vector centre_velocity(Side side);
/// Returns the acceleration of C.
mechanics::Vector centre_acceleration(Side side);

/// Derive (4a) or (15a), and (4b) or (15b).
mechanics::Derivation horizontal_velocity(Side side);
mechanics::Derivation vertical_velocity(Side side);

/// Adds the derivations of (2) to (4), (12), (13), (15).
void derive_kinematics(paper::Derivations& rows);

}  // namespace rederive::rocking_block
