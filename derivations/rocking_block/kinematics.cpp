#include <derivations/rocking_block/kinematics.hpp>

namespace rederive {

using GiNaC::ex;

ex inclination(Side side) {
  const Letters& s = letters();
  return side == Side::negative ? s.alpha + s.theta : s.alpha - s.theta;
}

Vector centre_from_pivot(Side side) {
  const Letters& s = letters();
  const ex upright = inclination(side), across = s.R * sin(upright);
  return {side == Side::negative ? across : -across, s.R * cos(upright)};
}

Vector centre_displacement(Side side) {
  const Vector now = centre_from_pivot(side);
  const ex at_rest = letters().theta == 0;
  return {now.right - now.right.subs(at_rest), now.up - now.up.subs(at_rest)};
}

Vector centre_velocity(Side side) {
  return time_derivative(Vector{letters().u_g, 0} + centre_from_pivot(side), block_rates());
}

Vector centre_acceleration(Side side) { return time_derivative(centre_velocity(side), block_rates()); }

namespace {

const char* place_of_centre(Side side) {
  return side == Side::negative ? "Turning clockwise by θ < 0 about O, C stays at the distance R from O, "
                                  "inclined by α + θ to the "
                                  "vertical, to the right of O"
                                : "Turning clockwise by θ > 0 about O', C stays at the distance R from O', "
                                  "inclined by α − θ to the "
                                  "vertical, to the left of O'";
}

// x_c counts the way from rest to the left about O and to the right about O': positive in both cases.
ex way_of_centre(Side side) {
  const Letters& s = letters();
  const ex moved = centre_displacement(side).right;
  const ex b = s.R * sin(s.alpha);
  return (side == Side::negative ? ex(-moved) : moved).subs(b == s.b);
}

Derivation total_displacement(Side side) {
  const Letters& s = letters();
  const bool left = side == Side::negative;
  return derived(s.u_c, left ? s.u_g - s.x_c : s.u_g + s.x_c,
                 {in_words(place_of_centre(side)),
                  {"against the ground C moves by", s.u_c - s.u_g, centre_displacement(side).right},
                  {left ? "which is to the left, and x_c is counted to the left"
                        : "which is to the right, and x_c is counted to the right",
                   s.x_c, way_of_centre(side)}});
}

Derivation horizontal_displacement(Side side) {
  const Letters& s = letters();
  return derived(
      s.x_c, way_of_centre(side),
      {in_words(place_of_centre(side)), {"at rest it is half a width away", s.b, s.R * sin(s.alpha)}},
      sides_of_the_block());
}

Derivation vertical_displacement(Side side) {
  const Letters& s = letters();
  return derived(
      s.y_c, centre_displacement(side).up,
      {in_words(place_of_centre(side)),
       {"so it stands above the pivot by", s.y_c + s.R * cos(s.alpha), centre_from_pivot(side).up}});
}

}  // namespace

Derivation horizontal_velocity(Side side) {
  const Letters& s = letters();
  return derived(
      s.u_cdot, centre_velocity(side).right,
      {{"The way of C", s.u_c, s.u_g + centre_displacement(side).right}, in_words("differentiated")});
}

Derivation vertical_velocity(Side side) {
  const Letters& s = letters();
  return derived(s.y_cdot, centre_velocity(side).up,
                 {{"The rise of C", s.y_c, centre_displacement(side).up}, in_words("differentiated")});
}

Derivation equation_2a() { return total_displacement(Side::negative); }
Derivation equation_2b() { return horizontal_displacement(Side::negative); }
Derivation equation_3() { return vertical_displacement(Side::negative); }
Derivation equation_4a() { return horizontal_velocity(Side::negative); }
Derivation equation_4b() { return vertical_velocity(Side::negative); }
Derivation equation_12a() { return total_displacement(Side::positive); }
Derivation equation_12b() { return horizontal_displacement(Side::positive); }
Derivation equation_13() { return vertical_displacement(Side::positive); }
Derivation equation_15a() { return horizontal_velocity(Side::positive); }
Derivation equation_15b() { return vertical_velocity(Side::positive); }

}  // namespace rederive
