// Where the centre of mass is, and how it moves: (2) to (4) for θ < 0 about O, (12), (13), (15) for θ > 0
// about O'.
#pragma once

#include <derivations/rocking_block/letters.hpp>

namespace rederive {

/// The angle between the line from the pivot to C and the vertical: α + θ about O, α − θ about O'.
GiNaC::ex inclination(Side side);
/// C as seen from the pivot, at distance R and that inclination, to the right of O and to the left of O'.
Vector centre_from_pivot(Side side);
/// How far C has moved against the ground since rest.
Vector centre_displacement(Side side);
/// The velocity of C, whose pivot moves with the ground.
Vector centre_velocity(Side side);
/// The acceleration of C.
Vector centre_acceleration(Side side);

Derivation equation_2a();
Derivation equation_2b();
Derivation equation_3();
Derivation equation_4a();
Derivation equation_4b();
Derivation equation_12a();
Derivation equation_12b();
Derivation equation_13();
Derivation equation_15a();
Derivation equation_15b();

/// (4a), (15a) and (4b), (15b) for either side.
Derivation horizontal_velocity(Side side);
Derivation vertical_velocity(Side side);

}  // namespace rederive
