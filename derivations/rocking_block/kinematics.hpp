// Where the centre of mass is, and how it moves: (2) to (4) for θ < 0 about O, (12), (13), (15) for θ > 0
// about O'.
#pragma once

#include <derivations/mechanics/plane.hpp>
#include <derivations/paper/derivations.hpp>
#include <derivations/paper/steps.hpp>
#include <derivations/rocking_block/symbols.hpp>

namespace rederive::rocking_block {

/// On which side the block rocks: θ < 0 about O (Fig. 2a), θ > 0 about O' (Fig. 2b).
enum class Side { negative, positive };

/// The rates along any motion of block and ground: θ → θ̇ → θ̈, u_g → u̇_g → ü_g.
Rates block_rates();
/// b = R sin α, h = R cos α.
std::vector<Given> sides_of_the_block();

/// C as seen from the pivot, at distance R, inclined by α ± θ, to the right of O and to the left of O'.
Vector centre_from_pivot(Side side);
/// How far C has moved against the ground since rest.
Vector centre_displacement(Side side);
/// The velocity of C, whose pivot moves with the ground.
Vector centre_velocity(Side side);
/// The acceleration of C.
Vector centre_acceleration(Side side);

/// (4a), (15a) and (4b), (15b) for either side.
Derivation horizontal_velocity(Side side);
Derivation vertical_velocity(Side side);

/// (2) to (4), (12), (13), (15).
Derivations derivations_of_kinematics();

}  // namespace rederive::rocking_block
