#include <derivations/rocking_block/initiation.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace paper;

using GiNaC::ex;
using GiNaC::lst;

namespace {

// Returns the left side of (11) at rest: the moments about O of the weight and of the ground acceleration.
ex moment_at_rest() { return motion_by_lagrange(Side::negative).subs(lst{theta == 0, thetaddot == 0}); }

// Returns the expression at t = 0+, when the block is upright and has not yet moved, but accelerates.
ex at_start(const ex& e) {
  return e.subs(lst{theta == 0, thetadot == 0, thetaddot == thetaddot_0, u_gddot == u_gddot_0});
}

ex first_horizontal_force() { return (m * at_start(centre_acceleration(Side::negative).right)).expand(); }

ex first_vertical_force() { return (m * (g + at_start(centre_acceleration(Side::negative).up))).expand(); }

ex by_share(const ex& e) { return e.subs(u_gddot_0 == lambda * a_p); }

// Returns the clockwise moment about C of the reaction at O, minus the moment that the angular acceleration
// needs.
ex moments_about_centre() { return clockwise_cross({-b, -h}, {H_0, V_0}) - J_c * thetaddot_0; }

Given share() { return {u_gddot_0, lambda * a_p}; }

const char* newton_right = "Newton, to the right: H is what accelerates C, at t = 0+ and θ = 0";

const char* newton_up = "Newton, upwards: V carries the weight and accelerates C, at t = 0+ and θ = 0";

}  // namespace

ex acceleration_that_suffices() {
  const ex moment = moment_at_rest();
  return -moment.coeff(u_gddot, 0) / moment.coeff(u_gddot, 1);
}

ex first_angular_acceleration() {
  const ex balance = moments_about_centre().subs(lst{H_0 == by_share(first_horizontal_force()),
                                                     V_0 == first_vertical_force(), b == R * sin(alpha),
                                                     h == R * cos(alpha), J_c == m * pow(R, 2) / 3});
  const ex plain = by_pythagoras(balance);
  return (-plain.coeff(thetaddot_0, 0) / plain.coeff(thetaddot_0, 1)).normal().expand();
}

ex first_friction_demand() {
  const ex start = thetaddot_0 == first_angular_acceleration();
  const ex across = by_share(first_horizontal_force() / m).expand().subs(start).expand();
  const ex up = (first_vertical_force() / m).expand().subs(start).expand();
  return across / up;
}

ex slope_of_diagonal() {
  const Vector centre = centre_from_pivot(Side::negative);
  const ex at_rest = theta == 0;
  return centre.right.subs(at_rest) / centre.up.subs(at_rest);
}

namespace {

Derivation force_before_rocking() {
  return derived(
      H, m * u_gddot,
      {in_words("As long as the block stands, C moves with the ground; H is what accelerates it")});
}

Derivation start_of_gradual_pulse() {
  return derived(lambda * a_p, acceleration_that_suffices(),
                 {from(first_acceleration(), "A pulse that grows from zero sets the block in motion when"),
                  in_words("time is counted from there, and λ α_p is the acceleration at that moment")});
}

}  // namespace

Derivation first_acceleration() {
  return derived(
      u_gddot_0, acceleration_that_suffices(),
      {from("23", "Rocking begins when the moment of the weight is reached, #"), in_words("with H = m ü_g")});
}

// This function is long because it is a list with one entry for each row.
void derive_initiation(Derivations& rows) {
  rows.add("23", [] {
    const ex moment = moment_at_rest();
    const ex force = moment.coeff(u_gddot, 1) * H / m, hold = -moment.coeff(u_gddot, 0);
    return derived(
        force, hold,
        {from("11", "In"),
         in_words("the block turns about O (θ̈ < 0) as soon as the moment of H = m ü_g, which acts at the "
                  "height of C, exceeds that of the weight")},
        {}, ">=");
  });
  rows.add("u9a", force_before_rocking);
  rows.add("u9b", [] {
    return assuming(
        derived(m * u_gddot, m * a_p,
                {in_words("The ground acceleration reaches its amplitude α_p at its peak, and only there")}),
        "u_gddot = a_p: the ground acceleration is at its peak");
  });
  rows.add("24a", [] {
    return derived(a_p, acceleration_that_suffices(),
                   {from("23", "The condition"), from(force_before_rocking(), "with"),
                    in_words("must be met at some time, so it must be met at the peak, where ü_g = α_p; "
                             "divide by m R cos α")},
                   {}, ">=");
  });
  rows.add("24b", [] {
    return derived(a_p_min, acceleration_that_suffices(), {from("24a", "The smallest amplitude that meets")});
  });
  rows.add("25a", [] { return derived(H_0, first_horizontal_force(), {in_words(newton_right)}); });
  rows.add("25b", [] {
    const ex force = by_share(first_horizontal_force()).subs(R * cos(alpha) == h);
    std::vector<Given> given = sides_of_the_block();
    given.push_back(share());
    return derived(
        H_0, force,
        {from("25a", "The force"), {"with λ, the share of the amplitude", u_gddot_0, lambda * a_p}}, given);
  });
  rows.add("26a", [] { return derived(V_0, first_vertical_force(), {in_words(newton_up)}); });
  rows.add("26b", [] {
    return derived(V_0, first_vertical_force(), {from("26a", "The force #, in b")}, sides_of_the_block());
  });
  rows.add("27", [] {
    return derived(
        -moments_about_centre(), 0,
        {in_words("H(0) and V(0) act at O, b to the left of C and h below it: their clockwise moment about C "
                  "is b V(0) − h H(0), and it gives the angular acceleration; the weight has none")});
  });
  rows.add("u10a", [] {
    return derived(1, lambda, {in_words("λ α_p = ü_g(0) cannot exceed the amplitude α_p, which is positive")},
                   {}, ">=");
  });
  rows.add("u10b", [] {
    return derived(lambda * a_p, acceleration_that_suffices(),
                   {from("23", "Rocking must begin at t = 0, #"), in_words("with H = m λ α_p")}, {}, ">=");
  });
  rows.add("28a", [] {
    const ex radius = 3 * g / (4 * pow(p, 2));
    return derived(thetaddot_0, first_angular_acceleration().subs(R == radius).expand(),
                   {from("25b", "Put"),
                    from("26b", "and"),
                    from("27", "into"),
                    {"with", J_c, m * pow(R, 2) / 3},
                    {"and", R, radius}});
  });
  rows.add("28b", [] {
    return derived(pow(p, 2), m * g * R / moment_of_inertia_about_pivot().right,
                   {in_words("As in (21): the moment m g R of the weight over J_o")});
  });
  rows.add("30", [] {
    return derived(mu, H_0 / V_0, {in_words("Divide (29) by V(0): the ground can only push, V(0) > 0")}, {},
                   ">=");
  });
  rows.add("31", [] {
    return derived(mu, first_friction_demand(),
                   {from("30", "In"), from("25b", "put"), from("26b", "and"), from("28a", "with")}, {}, ">=");
  });
  rows.add("u11", start_of_gradual_pulse);
  rows.add("32a", [] {
    const ex slope = sin(alpha) / cos(alpha);
    const ex gradual = first_friction_demand().subs(lambda == g * slope / a_p).normal();
    return derived(mu, gradual,
                   {from("31", "In"),
                    {"put the acceleration that just suffices, as it does where it grows from zero",
                     lambda * a_p, g * tan(alpha)}},
                   sides_of_the_block(), ">=");
  });
  rows.add("32b", [] {
    return derived(b / h, slope_of_diagonal(), {in_words("The sides of the block, R sin α and R cos α")});
  });
  rows.add("33", [] {
    return assuming(
        derived(mu, H / V,
                {in_words("Coulomb: no sliding while |H| < μ V, with V > 0 as long as there is contact"),
                 in_words("which is this for H > 0, and μ > −H/V for H < 0")},
                {}, ">"),
        "H >= 0; where H < 0 the condition is mu > -H/V");
  });
  rows.add("u18", start_of_gradual_pulse);
}

}  // namespace rederive::rocking_block
