#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace paper;

using GiNaC::ex;

RigidBody block_from_pivot(Side side) {
  const ex width = 2 * b, density = m / (4 * b * h);
  if (side == Side::negative) return rectangle(x, y, 0, width, 0, 2 * h, density);
  return rectangle(x, y, -width, 0, 0, 2 * h, density);
}

namespace {

RigidBody block_from_centre() { return rectangle(x, y, -b, b, -h, h, m / (4 * b * h)); }

}  // namespace

std::vector<Given> inertia_and_frequency() {
  const ex radius = 3 * g / (4 * pow(p, 2));
  return {{J_o, ex(4) / 3 * m * pow(radius, 2)}, {R, radius}};
}

ex kinetic_energy(Side side) {
  const Vector velocity = centre_velocity(side);
  const ex translation = m / 2 * dot(velocity, velocity), rotation = J_c / 2 * pow(thetadot, 2);
  // By the parallel-axis theorem a body that moves with C and turns about it with J_c turns about the pivot
  // with J_o.
  return by_pythagoras((translation + rotation).subs(J_c == J_o - m * pow(R, 2)));
}

ex weight_potential(Side side) { return m * g * R * (centre_displacement(side).up / R).expand(); }

namespace {

// Returns the terms of Lagrange's equation. They are derived once, for half of the paper's equations need
// them.
const LagrangeTerms& block_lagrange_terms(Side side) {
  const auto terms = [](Side on) {
    return lagrange_terms(kinetic_energy(on), weight_potential(on), {theta, thetadot, thetaddot},
                          block_rates());
  };
  static const LagrangeTerms negative = terms(Side::negative), positive = terms(Side::positive);
  return side == Side::negative ? negative : positive;
}

}  // namespace

ex motion_by_lagrange(Side side) { return block_lagrange_terms(side).sum().expand(); }

ex motion_by_moments(Side side) {
  const ex across = side == Side::negative ? b : -b;
  const AppliedForce weight{turned_clockwise({across, h}, theta), {0, -m * g}};
  const Vector element = turned_clockwise({x, y}, theta);
  // The reaction acts at the pivot and has no moment about it.
  return -moment_balance(block_from_pivot(side), element, {u_g, 0}, {weight}, block_rates());
}

ex angular_acceleration(Side side) {
  const ex motion = motion_by_lagrange(side);
  const ex solved = -motion.coeff(thetaddot, 0) / motion.coeff(thetaddot, 1);
  return solved.subs(J_o == ex(4) / 3 * m * pow(R, 2)).subs(R == 3 * g / (4 * pow(p, 2))).expand();
}

namespace {

// Returns b² = R² − h², with which J_o becomes 4/3 m R².
ex squared_width() { return pow(b, 2) == pow(R, 2) - pow(h, 2); }

Derivation equation_1() {
  const LagrangeTerms terms = block_lagrange_terms(Side::negative);
  std::vector<Given> given = sides_of_the_block();
  given.push_back({ddt_dK_dthetadot, terms.momentum_rate.subs(J_o == ex(4) / 3 * m * pow(R, 2))});
  given.push_back({dK_dtheta, terms.kinetic_slope});
  given.push_back({dOmega_dtheta, terms.potential_slope});
  return derived(
      motion_by_moments(Side::negative).subs(squared_width()).expand(), 0,
      {in_words("By the other road: every element has the acceleration of its point. The moments of the "
                "weight about O, less those that the accelerations need, add up to nothing"),
       in_words("With the energies of (6) and (9) Lagrange's equation must say the same")},
      given);
}

const char* pivot_name(Side side) { return side == Side::negative ? "O" : "O'"; }

Derivation inertia_about(Side side) {
  const ex sum = over_body(pow(x, 2) + pow(y, 2), block_from_pivot(side));
  return derived(
      J_o, by_pythagoras(sum.subs(GiNaC::lst{b == R * sin(alpha), h == R * cos(alpha)})),
      {{std::string("Integrate ρ (x² + y²) over the block, seen from ") + pivot_name(side), J_o, sum},
       {"with the half diagonal R", pow(R, 2), pow(b, 2) + pow(h, 2)},
       {"The parallel axis gives the same", J_o, J_c + m * pow(R, 2)}});
}

Derivation equation_5() {
  // Seen along axes fixed in the block, an element at (x, y) moves with C and turns about it.
  const Vector with_centre = turned_clockwise({u_cdot, y_cdot}, -theta);
  const Vector velocity = with_centre + thetadot * Vector{y, -x};
  const ex sum = by_pythagoras(over_body(dot(velocity, velocity) / 2, block_from_centre()));
  // The terms with b² and h² are those of J_c.
  const ex b_squared = 3 * J_c / m - pow(h, 2);
  return derived(K, sum.subs(pow(b, 2) == b_squared).expand(),
                 {in_words("Integrate ρ v²/2 over all elements: each moves with C and turns about C"),
                  from(moment_of_inertia_about_centre(), "The part that turns holds J_c")});
}

Derivation kinetic_energy_in_J_o(Side side) {
  return derived(
      K, kinetic_energy(side),
      {from("5", "By König's theorem, #, add the energies of the rotation about C and of C itself"),
       from(horizontal_velocity(side), "with the velocity of C"),
       from(vertical_velocity(side), "and"),
       {"and what J_o is", J_o, J_c + m * pow(R, 2)}});
}

Derivation weight(Side side) {
  return derived(Omega, weight_potential(side),
                 {{"The weight m g is lifted by", y_c, centre_displacement(side).up}});
}

Derivation momentum(Side side) {
  return derived(dK_dthetadot, block_lagrange_terms(side).momentum,
                 {from(kinetic_energy_in_J_o(side), "Differentiate by θ̇")});
}

Derivation momentum_rate(Side side) {
  return derived(ddt_dK_dthetadot, block_lagrange_terms(side).momentum_rate.expand(),
                 {from(momentum(side), "Differentiate by time; θ, θ̇ and u̇_g all depend on it")});
}

Derivation kinetic_slope(Side side) {
  return derived(dK_dtheta, block_lagrange_terms(side).kinetic_slope,
                 {from(kinetic_energy_in_J_o(side), "Differentiate by θ")});
}

Derivation potential_slope(Side side) {
  return derived(dOmega_dtheta, block_lagrange_terms(side).potential_slope.expand(),
                 {from(weight(side), "Differentiate by θ")});
}

Derivation motion(Side side) {
  return derived(motion_by_lagrange(side), 0,
                 {from(horizontal_velocity(side),
                       std::string("Turning about ") + pivot_name(side) + ", C moves to the right with"),
                  from(vertical_velocity(side), "and upwards with"),
                  from(kinetic_energy_in_J_o(side), "so that the kinetic energy is"),
                  from(weight(side), "and the potential"),
                  {"Into Lagrange's equation", ddt_dK_dthetadot - dK_dtheta + dOmega_dtheta, 0},
                  from(momentum_rate(side), "put"),
                  from(kinetic_slope(side), "and"),
                  from(potential_slope(side), "and"),
                  {std::string("The moments of all elements about ") + pivot_name(side) +
                       ", integrated over the block, say the same",
                   motion_by_moments(side), 0}});
}

Derivation normalised_motion(Side side) {
  const Derivation before = motion(side);
  return derived(thetaddot - angular_acceleration(side), 0,
                 as_before({before}, {{"Divide by", J_o, ex(4) / 3 * m * pow(R, 2)},
                                      {"so that the weight enters by", pow(p, 2), m * g * R / J_o}}),
                 inertia_and_frequency());
}

}  // namespace

Derivation moment_of_inertia_about_centre() {
  const ex sum = over_body(pow(x, 2) + pow(y, 2), block_from_centre());
  return derived(J_c, by_pythagoras(sum.subs(GiNaC::lst{b == R * sin(alpha), h == R * cos(alpha)})),
                 {{"Integrate ρ (x² + y²) over the block, seen from C", J_c, sum},
                  {"with the half diagonal R", pow(R, 2), pow(b, 2) + pow(h, 2)}});
}

Derivation moment_of_inertia_about_pivot() { return inertia_about(Side::negative); }
Derivation frequency_parameter() {
  const ex inertia = moment_of_inertia_about_pivot().right;
  return derived(p, sqrt(m * g * R / inertia),
                 {{"In (11) and (20), divided by J_o, the weight enters by", pow(p, 2), m * g * R / J_o},
                  {"where", J_o, inertia}});
}

// This function is long because it is a list with one entry for each row.
void derive_equation_of_motion(Derivations& rows) {
  rows.add("1", equation_1);
  rows.add("5", equation_5);
  rows.add("u2", moment_of_inertia_about_centre);
  rows.add("6", [] { return kinetic_energy_in_J_o(Side::negative); });
  rows.add("u3a", [] {
    const ex square = pow(x, 2) + pow(y, 2);
    const ex more =
        over_body(square, block_from_pivot(Side::negative)) - over_body(square, block_from_centre());
    const auto sides = GiNaC::lst{b == R * sin(alpha), h == R * cos(alpha)};
    return derived(J_o, J_c + by_pythagoras(more.subs(sides)),
                   {{"Integrate ρ (x² + y²) seen from O and seen from C; the first exceeds the second by",
                     J_o - J_c, more}});
  });
  rows.add("u3b", moment_of_inertia_about_pivot);
  rows.add("7a", [] { return momentum(Side::negative); });
  rows.add("7b", [] { return momentum_rate(Side::negative); });
  rows.add("8", [] { return kinetic_slope(Side::negative); });
  rows.add("9", [] { return weight(Side::negative); });
  rows.add("10", [] { return potential_slope(Side::negative); });
  rows.add("11", [] { return motion(Side::negative); });
  rows.add("14", [] { return weight(Side::positive); });
  rows.add("16a", equation_5);
  rows.add("16b", [] { return kinetic_energy_in_J_o(Side::positive); });
  rows.add("u4", [] { return inertia_about(Side::positive); });
  rows.add("17a", [] { return momentum(Side::positive); });
  rows.add("17b", [] { return momentum_rate(Side::positive); });
  rows.add("18", [] { return kinetic_slope(Side::positive); });
  rows.add("19", [] { return potential_slope(Side::positive); });
  rows.add("20", [] { return motion(Side::positive); });
  rows.add("21a", [] { return normalised_motion(Side::negative); });
  rows.add("21b", [] { return normalised_motion(Side::positive); });
  rows.add("u5", frequency_parameter);
}

}  // namespace rederive::rocking_block
