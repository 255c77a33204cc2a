#include <derivations/mechanics/moment_balance.hpp>
#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive {

using GiNaC::ex;

Rectangle block_from_pivot(Side side) {
  const Letters& s = letters();
  const ex width = 2 * s.b, density = s.m / (4 * s.b * s.h);
  if (side == Side::negative) return {s.x, s.y, 0, width, 0, 2 * s.h, density};
  return {s.x, s.y, -width, 0, 0, 2 * s.h, density};
}

Rectangle block_from_centre() {
  const Letters& s = letters();
  return {s.x, s.y, -s.b, s.b, -s.h, s.h, s.m / (4 * s.b * s.h)};
}

ex kinetic_energy(Side side) {
  const Letters& s = letters();
  const Vector velocity = centre_velocity(side);
  const ex translation = s.m / 2 * dot(velocity, velocity), rotation = s.J_c / 2 * pow(s.thetadot, 2);
  // The parallel axis: what turns about C with J_c and moves with C turns about the pivot with J_o.
  const ex J_c = s.J_o - s.m * pow(s.R, 2);
  return by_pythagoras((translation + rotation).subs(s.J_c == J_c));
}

ex weight_potential(Side side) {
  const Letters& s = letters();
  return s.m * s.g * s.R * (centre_displacement(side).up / s.R).expand();
}

LagrangeTerms block_lagrange_terms(Side side) {
  const Letters& s = letters();
  return lagrange_terms(kinetic_energy(side), weight_potential(side), {s.theta, s.thetadot, s.thetaddot},
                        block_rates());
}

ex motion_by_lagrange(Side side) { return block_lagrange_terms(side).sum().expand(); }

ex motion_by_moments(Side side) {
  const Letters& s = letters();
  const ex across = side == Side::negative ? s.b : -s.b;
  const AppliedForce weight{turned_clockwise({across, s.h}, s.theta), {0, -s.m * s.g}};
  const Vector element = turned_clockwise({s.x, s.y}, s.theta);
  // The reaction acts at the pivot and has no moment about it.
  return -moment_balance(block_from_pivot(side), element, {s.u_g, 0}, {weight}, block_rates());
}

ex angular_acceleration(Side side) {
  const Letters& s = letters();
  const ex motion = motion_by_lagrange(side);
  const ex solved = -motion.coeff(s.thetaddot, 0) / motion.coeff(s.thetaddot, 1);
  const ex J_o = ex(4) / 3 * s.m * pow(s.R, 2);
  return solved.subs(s.J_o == J_o).subs(s.R == 3 * s.g / (4 * pow(s.p, 2))).expand();
}

namespace {

const char* pivot_name(Side side) { return side == Side::negative ? "O" : "O'"; }

Derivation kinetic_energy_in_J_o(Side side) {
  const Letters& s = letters();
  return derived(
      s.K, kinetic_energy(side),
      {from(Cited{"5", equation_5}, "König, #: the energy of the rotation about C and of C itself"),
       from(horizontal_velocity(side), "with the velocity of C"),
       from(vertical_velocity(side), "and"),
       {"and what J_o is", s.J_o, s.J_c + s.m * pow(s.R, 2)}});
}

Derivation weight(Side side) {
  const Letters& s = letters();
  return derived(s.Omega, weight_potential(side),
                 {{"The weight m g is lifted by", s.y_c, centre_displacement(side).up}});
}

Derivation momentum(Side side) {
  const Letters& s = letters();
  return derived(s.dK_dthetadot, block_lagrange_terms(side).momentum,
                 {from(kinetic_energy_in_J_o(side), "Differentiate by θ̇")});
}

Derivation momentum_rate(Side side) {
  const Letters& s = letters();
  return derived(s.ddt_dK_dthetadot, block_lagrange_terms(side).momentum_rate.expand(),
                 {from(momentum(side), "Differentiate by time; θ, θ̇ and u̇_g all depend on it")});
}

Derivation kinetic_slope(Side side) {
  const Letters& s = letters();
  return derived(s.dK_dtheta, block_lagrange_terms(side).kinetic_slope,
                 {from(kinetic_energy_in_J_o(side), "Differentiate by θ")});
}

Derivation potential_slope(Side side) {
  const Letters& s = letters();
  return derived(s.dOmega_dtheta, block_lagrange_terms(side).potential_slope.expand(),
                 {from(weight(side), "Differentiate by θ")});
}

Derivation motion(Side side) {
  const Letters& s = letters();
  return derived(motion_by_lagrange(side), 0,
                 {from(horizontal_velocity(side),
                       std::string("Turning about ") + pivot_name(side) + ", C moves to the right with"),
                  from(vertical_velocity(side), "and upwards with"),
                  from(kinetic_energy_in_J_o(side), "so that the kinetic energy is"),
                  from(weight(side), "and the potential"),
                  {"Lagrange's equation", s.ddt_dK_dthetadot - s.dK_dtheta + s.dOmega_dtheta, 0},
                  from(momentum_rate(side), "takes"),
                  from(kinetic_slope(side), "and"),
                  from(potential_slope(side), "and"),
                  {std::string("By the other road, the moments of all elements about ") + pivot_name(side) +
                       ", it is the same",
                   motion_by_moments(side), 0}});
}

Derivation normalised_motion(Side side) {
  const Letters& s = letters();
  const Derivation before = motion(side);
  return derived(
      s.thetaddot - angular_acceleration(side), 0,
      as_before({before}, {{"Divide by", s.J_o, ex(4) / 3 * s.m * pow(s.R, 2)},
                           {"so that the weight enters by", pow(s.p, 2), s.m * s.g * s.R / s.J_o}}),
      inertia_and_frequency());
}

}  // namespace

namespace {

// b² = R² − h²: leaves J_o as 4/3 m R².
ex squared_width() {
  const Letters& s = letters();
  return pow(s.b, 2) == pow(s.R, 2) - pow(s.h, 2);
}

}  // namespace

Derivation equation_1() {
  const Letters& s = letters();
  const LagrangeTerms terms = block_lagrange_terms(Side::negative);
  std::vector<Given> given = sides_of_the_block();
  given.push_back({s.ddt_dK_dthetadot, terms.momentum_rate.subs(s.J_o == ex(4) / 3 * s.m * pow(s.R, 2))});
  given.push_back({s.dK_dtheta, terms.kinetic_slope});
  given.push_back({s.dOmega_dtheta, terms.potential_slope});
  return derived(
      motion_by_moments(Side::negative).subs(squared_width()).expand(), 0,
      {in_words("By the other road: every element has the acceleration of its point. The moments of the "
                "weight about O, less those that the accelerations need, add up to nothing"),
       in_words("With the energies of (6) and (9) Lagrange's equation must say the same")},
      given);
}

Derivation moment_of_inertia_about_centre() {
  const Letters& s = letters();
  const ex sum = over_body(pow(s.x, 2) + pow(s.y, 2), block_from_centre());
  return derived(s.J_c,
                 by_pythagoras(sum.subs(GiNaC::lst{s.b == s.R * sin(s.alpha), s.h == s.R * cos(s.alpha)})),
                 {{"Integrate ρ (x² + y²) over the block, seen from C", s.J_c, sum},
                  {"with the half diagonal R", pow(s.R, 2), pow(s.b, 2) + pow(s.h, 2)}});
}

namespace {

Derivation inertia_about(Side side) {
  const Letters& s = letters();
  const ex sum = over_body(pow(s.x, 2) + pow(s.y, 2), block_from_pivot(side));
  return derived(
      s.J_o, by_pythagoras(sum.subs(GiNaC::lst{s.b == s.R * sin(s.alpha), s.h == s.R * cos(s.alpha)})),
      {{std::string("Integrate ρ (x² + y²) over the block, seen from ") + pivot_name(side), s.J_o, sum},
       {"with the half diagonal R", pow(s.R, 2), pow(s.b, 2) + pow(s.h, 2)},
       {"The parallel axis gives the same", s.J_o, s.J_c + s.m * pow(s.R, 2)}});
}

}  // namespace

Derivation parallel_axis() {
  const Letters& s = letters();
  const ex square = pow(s.x, 2) + pow(s.y, 2);
  const ex more =
      over_body(square, block_from_pivot(Side::negative)) - over_body(square, block_from_centre());
  const auto sides = GiNaC::lst{s.b == s.R * sin(s.alpha), s.h == s.R * cos(s.alpha)};
  return derived(s.J_o, s.J_c + by_pythagoras(more.subs(sides)),
                 {{"Integrate ρ (x² + y²) seen from O and seen from C; the first exceeds the second by",
                   s.J_o - s.J_c, more}});
}

Derivation moment_of_inertia_about_pivot() { return inertia_about(Side::negative); }
Derivation moment_of_inertia_about_other_pivot() { return inertia_about(Side::positive); }

Derivation frequency_parameter() {
  const Letters& s = letters();
  const ex J_o = moment_of_inertia_about_pivot().right;
  return derived(
      s.p, sqrt(s.m * s.g * s.R / J_o),
      {{"In (11) and (20), divided by J_o, the weight enters by", pow(s.p, 2), s.m * s.g * s.R / s.J_o},
       {"where", s.J_o, J_o}});
}

Derivation equation_5() {
  const Letters& s = letters();
  // Seen along axes fixed in the block, an element at (x, y) moves with C and turns about it.
  const Vector with_centre = turned_clockwise({s.u_cdot, s.y_cdot}, -s.theta);
  const Vector velocity = with_centre + s.thetadot * Vector{s.y, -s.x};
  const ex sum = by_pythagoras(over_body(dot(velocity, velocity) / 2, block_from_centre()));
  // What b² and h² make up in it is J_c.
  const ex b_squared = 3 * s.J_c / s.m - pow(s.h, 2);
  return derived(s.K, sum.subs(pow(s.b, 2) == b_squared).expand(),
                 {in_words("Integrate ρ v²/2 over all elements: each moves with C and turns about C"),
                  from(moment_of_inertia_about_centre(), "The part that turns holds J_c")});
}

Derivation equation_6() { return kinetic_energy_in_J_o(Side::negative); }
Derivation equation_7a() { return momentum(Side::negative); }
Derivation equation_7b() { return momentum_rate(Side::negative); }
Derivation equation_8() { return kinetic_slope(Side::negative); }
Derivation equation_9() { return weight(Side::negative); }
Derivation equation_10() { return potential_slope(Side::negative); }
Derivation equation_11() { return motion(Side::negative); }
Derivation equation_14() { return weight(Side::positive); }
Derivation equation_16a() { return equation_5(); }
Derivation equation_16b() { return kinetic_energy_in_J_o(Side::positive); }
Derivation equation_17a() { return momentum(Side::positive); }
Derivation equation_17b() { return momentum_rate(Side::positive); }
Derivation equation_18() { return kinetic_slope(Side::positive); }
Derivation equation_19() { return potential_slope(Side::positive); }
Derivation equation_20() { return motion(Side::positive); }
Derivation equation_21a() { return normalised_motion(Side::negative); }
Derivation equation_21b() { return normalised_motion(Side::positive); }

}  // namespace rederive
