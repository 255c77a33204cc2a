#include <derivations/rocking_block/kinematics.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace paper;

using GiNaC::ex;

Rates block_rates() { return {{theta, thetadot}, {thetadot, thetaddot}, {u_g, u_gdot}, {u_gdot, u_gddot}}; }

std::vector<Given> sides_of_the_block() { return {{b, R * sin(alpha)}, {h, R * cos(alpha)}}; }

namespace {

ex inclination(Side side) { return side == Side::negative ? alpha + theta : alpha - theta; }

}  // namespace

Vector centre_from_pivot(Side side) {
  const ex upright = inclination(side), across = R * sin(upright);
  return {side == Side::negative ? across : -across, R * cos(upright)};
}

Vector centre_displacement(Side side) {
  const Vector now = centre_from_pivot(side);
  const ex at_rest = theta == 0;
  return {now.right - now.right.subs(at_rest), now.up - now.up.subs(at_rest)};
}

Vector centre_velocity(Side side) {
  return time_derivative(Vector{u_g, 0} + centre_from_pivot(side), block_rates());
}

Vector centre_acceleration(Side side) { return time_derivative(centre_velocity(side), block_rates()); }

Derivation horizontal_velocity(Side side) {
  return derived(u_cdot, centre_velocity(side).right,
                 {{"The way of C", u_c, u_g + centre_displacement(side).right}, in_words("differentiated")});
}

Derivation vertical_velocity(Side side) {
  return derived(y_cdot, centre_velocity(side).up,
                 {{"The rise of C", y_c, centre_displacement(side).up}, in_words("differentiated")});
}

namespace {

const char* place_of_centre(Side side) {
  return side == Side::negative
             ? "Turning counterclockwise, by θ < 0, about O, C stays at the distance R from O, "
               "inclined by α + θ to the "
               "vertical, to the right of O"
             : "Turning clockwise, by θ > 0, about O', C stays at the distance R from O', "
               "inclined by α − θ to the "
               "vertical, to the left of O'";
}

// Returns x_c, the displacement from rest, to the left about O and to the right about O': positive in both
// cases.
ex way_of_centre(Side side) {
  const ex moved = centre_displacement(side).right;
  const ex half_width = R * sin(alpha);
  return (side == Side::negative ? ex(-moved) : moved).subs(half_width == b);
}

Derivation total_displacement(Side side) {
  const bool left = side == Side::negative;
  return derived(u_c, left ? u_g - x_c : u_g + x_c,
                 {in_words(place_of_centre(side)),
                  {"against the ground C moves by", u_c - u_g, centre_displacement(side).right},
                  {left ? "which is to the left, and x_c is counted to the left"
                        : "which is to the right, and x_c is counted to the right",
                   x_c, way_of_centre(side)}});
}

Derivation horizontal_displacement(Side side) {
  return derived(x_c, way_of_centre(side),
                 {in_words(place_of_centre(side)), {"at rest it is half a width away", b, R * sin(alpha)}},
                 sides_of_the_block());
}

Derivation vertical_displacement(Side side) {
  return derived(y_c, centre_displacement(side).up,
                 {in_words(place_of_centre(side)),
                  {"so it stands above the pivot by", y_c + R * cos(alpha), centre_from_pivot(side).up}});
}

}  // namespace

// This function is long because it is a list with one entry for each row.
void derive_kinematics(Derivations& rows) {
  rows.add("2a", [] { return total_displacement(Side::negative); });
  rows.add("2b", [] { return horizontal_displacement(Side::negative); });
  rows.add("3", [] { return vertical_displacement(Side::negative); });
  rows.add("4a", [] { return horizontal_velocity(Side::negative); });
  rows.add("4b", [] { return vertical_velocity(Side::negative); });
  rows.add("12a", [] { return total_displacement(Side::positive); });
  rows.add("12b", [] { return horizontal_displacement(Side::positive); });
  rows.add("13", [] { return vertical_displacement(Side::positive); });
  rows.add("15a", [] { return horizontal_velocity(Side::positive); });
  rows.add("15b", [] { return vertical_velocity(Side::positive); });
}

}  // namespace rederive::rocking_block
