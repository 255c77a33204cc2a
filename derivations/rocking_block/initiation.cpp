#include <derivations/rocking_block/initiation.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::lst;

namespace {

// The moment about O that the weight can hold and the one that the ground acceleration exerts, at rest: (11)
// there.
ex moment_at_rest() {
  const Letters& s = letters();
  return motion_by_lagrange(Side::negative).subs(lst{s.theta == 0, s.thetaddot == 0});
}

// At t = 0+ the block stands upright and has not yet moved, but accelerates.
ex at_start(const ex& e) {
  const Letters& s = letters();
  return e.subs(lst{s.theta == 0, s.thetadot == 0, s.thetaddot == s.thetaddot_0, s.u_gddot == s.u_gddot_0});
}

ex first_horizontal_force() {
  const Letters& s = letters();
  return (s.m * at_start(centre_acceleration(Side::negative).right)).expand();
}

ex first_vertical_force() {
  const Letters& s = letters();
  return (s.m * (s.g + at_start(centre_acceleration(Side::negative).up))).expand();
}

ex by_share(const ex& e) {
  const Letters& s = letters();
  return e.subs(s.u_gddot_0 == s.lambda * s.a_p);
}

// The clockwise moment of the reaction at O about C, less what the angular acceleration needs.
ex moments_about_centre() {
  const Letters& s = letters();
  return clockwise_cross({-s.b, -s.h}, {s.H_0, s.V_0}) - s.J_c * s.thetaddot_0;
}

Given share() {
  const Letters& s = letters();
  return {s.u_gddot_0, s.lambda * s.a_p};
}

const char* newton_right = "Newton, to the right: H is what accelerates C, at t = 0+ and θ = 0";
const char* newton_up = "Newton, upwards: V carries the weight and accelerates C, at t = 0+ and θ = 0";

}  // namespace

ex acceleration_that_suffices() {
  const Letters& s = letters();
  const ex moment = moment_at_rest();
  return -moment.coeff(s.u_gddot, 0) / moment.coeff(s.u_gddot, 1);
}

ex first_angular_acceleration() {
  const Letters& s = letters();
  const ex balance = moments_about_centre().subs(
      lst{s.H_0 == by_share(first_horizontal_force()), s.V_0 == first_vertical_force(),
          s.b == s.R * sin(s.alpha), s.h == s.R * cos(s.alpha), s.J_c == s.m * pow(s.R, 2) / 3});
  const ex plain = by_pythagoras(balance);
  return (-plain.coeff(s.thetaddot_0, 0) / plain.coeff(s.thetaddot_0, 1)).normal().expand();
}

ex first_friction_demand() {
  const Letters& s = letters();
  const ex start = s.thetaddot_0 == first_angular_acceleration();
  const ex across = by_share(first_horizontal_force() / s.m).expand().subs(start).expand();
  const ex up = (first_vertical_force() / s.m).expand().subs(start).expand();
  return across / up;
}

Derivation equation_23() {
  const Letters& s = letters();
  const ex moment = moment_at_rest();
  const ex force = moment.coeff(s.u_gddot, 1) * s.H / s.m, hold = -moment.coeff(s.u_gddot, 0);
  return derived(
      force, hold,
      {from(Cited{"11", equation_11}, "In"),
       in_words("the block turns about O (θ̈ < 0) as soon as the moment of H = m ü_g, which acts at the "
                "height of C, exceeds that of the weight")},
      {}, ">=");
}

Derivation force_before_rocking() {
  const Letters& s = letters();
  return derived(
      s.H, s.m * s.u_gddot,
      {in_words("As long as the block stands, C moves with the ground; H is what accelerates it")});
}

Derivation force_at_peak() {
  const Letters& s = letters();
  Derivation result =
      derived(s.m * s.u_gddot, s.m * s.a_p,
              {in_words("The ground acceleration reaches its amplitude α_p at its peak, and only there")});
  result.assumption = "the ground acceleration is at its peak";
  return result;
}

Derivation equation_24a() {
  const Letters& s = letters();
  return derived(
      s.a_p, acceleration_that_suffices(),
      {from(Cited{"23", equation_23}, "The condition"), from(force_before_rocking(), "with"),
       in_words(
           "must be met at some time, so it must be met at the peak, where ü_g = α_p; divide by m R cos α")},
      {}, ">=");
}

Derivation equation_24b() {
  const Letters& s = letters();
  return derived(s.a_p_min, acceleration_that_suffices(),
                 {from(Cited{"24a", equation_24a}, "The smallest amplitude that meets")});
}

Derivation equation_25a() {
  return derived(letters().H_0, first_horizontal_force(), {in_words(newton_right)});
}

Derivation equation_25b() {
  const Letters& s = letters();
  const ex force = by_share(first_horizontal_force()).subs(s.R * cos(s.alpha) == s.h);
  std::vector<Given> given = sides_of_the_block();
  given.push_back(share());
  return derived(s.H_0, force,
                 {from(Cited{"25a", equation_25a}, "The force"),
                  {"with λ, the share of the amplitude", s.u_gddot_0, s.lambda * s.a_p}},
                 given);
}

Derivation equation_26a() { return derived(letters().V_0, first_vertical_force(), {in_words(newton_up)}); }

Derivation equation_26b() {
  const Letters& s = letters();
  return derived(s.V_0, first_vertical_force(), {from(Cited{"26a", equation_26a}, "The force #, in b")},
                 sides_of_the_block());
}

Derivation equation_27() {
  return derived(
      -moments_about_centre(), 0,
      {in_words("H(0) and V(0) act at O, b to the left of C and h below it: their clockwise moment about C "
                "is b V(0) − h H(0), and it gives the angular acceleration; the weight has none")});
}

Derivation share_at_most_one() {
  return derived(1, letters().lambda,
                 {in_words("λ α_p = ü_g(0) cannot exceed the amplitude α_p, which is positive")}, {}, ">=");
}

Derivation share_at_least() {
  const Letters& s = letters();
  return derived(
      s.lambda * s.a_p, acceleration_that_suffices(),
      {from(Cited{"23", equation_23}, "Rocking must begin at t = 0, #"), in_words("with H = m λ α_p")}, {},
      ">=");
}

Derivation equation_28a() {
  const Letters& s = letters();
  const ex R = 3 * s.g / (4 * pow(s.p, 2));
  return derived(s.thetaddot_0, first_angular_acceleration().subs(s.R == R).expand(),
                 {from(Cited{"25b", equation_25b}, "Put"),
                  from(Cited{"26b", equation_26b}, "and"),
                  from(Cited{"27", equation_27}, "into"),
                  {"with", s.J_c, s.m * pow(s.R, 2) / 3},
                  {"and", s.R, R}});
}

Derivation equation_28b() {
  const Letters& s = letters();
  return derived(pow(s.p, 2), s.m * s.g * s.R / moment_of_inertia_about_pivot().right,
                 {in_words("As in (21): the moment m g R of the weight over J_o")});
}

Derivation equation_30() {
  const Letters& s = letters();
  return derived(s.mu, s.H_0 / s.V_0, {in_words("Divide (29) by V(0): the ground can only push, V(0) > 0")},
                 {}, ">=");
}

Derivation equation_31() {
  const Letters& s = letters();
  return derived(s.mu, first_friction_demand(),
                 {from(Cited{"30", equation_30}, "In"), from(Cited{"25b", equation_25b}, "put"),
                  from(Cited{"26b", equation_26b}, "and"), from(Cited{"28a", equation_28a}, "with")},
                 {}, ">=");
}

Derivation first_acceleration() {
  return derived(
      letters().u_gddot_0, acceleration_that_suffices(),
      {from(Cited{"23", equation_23}, "Rocking begins when the moment of the weight is reached, #"),
       in_words("with H = m ü_g")});
}

Derivation start_of_gradual_pulse() {
  const Letters& s = letters();
  return derived(s.lambda * s.a_p, acceleration_that_suffices(),
                 {from(first_acceleration(), "A pulse that grows from zero sets the block in motion when"),
                  in_words("time is counted from there, and λ α_p is the acceleration at that moment")});
}

Derivation equation_32a() {
  const Letters& s = letters();
  const ex slope = sin(s.alpha) / cos(s.alpha);
  const ex gradual = first_friction_demand().subs(s.lambda == s.g * slope / s.a_p).normal();
  return derived(s.mu, gradual,
                 {from(Cited{"31", equation_31}, "In"),
                  {"put the acceleration that just suffices, as it does where it grows from zero",
                   s.lambda * s.a_p, s.g * tan(s.alpha)}},
                 sides_of_the_block(), ">=");
}

ex slope_of_diagonal() {
  const Vector centre = centre_from_pivot(Side::negative);
  const ex at_rest = letters().theta == 0;
  return centre.right.subs(at_rest) / centre.up.subs(at_rest);
}

Derivation equation_32b() {
  const Letters& s = letters();
  return derived(s.b / s.h, slope_of_diagonal(), {in_words("The sides of the block, R sin α and R cos α")});
}

Derivation equation_33() {
  const Letters& s = letters();
  Derivation result =
      derived(s.mu, s.H / s.V,
              {in_words("Coulomb: no sliding while |H| < μ V, with V > 0 as long as there is contact"),
               in_words("which is this for H > 0, and μ > −H/V for H < 0")},
              {}, ">");
  result.assumption = "H >= 0; where H < 0 the condition is mu > -H/V";
  return result;
}

}  // namespace rederive
