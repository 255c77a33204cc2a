#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/sliding.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::lst;

namespace {

ex with_motion(const ex& e, Side side) {
  const Letters& s = letters();
  return e.subs(s.thetaddot == angular_acceleration(side)).expand();
}

// x_c, y_c of (48), (49): for θ < 0 the way of C is u_c = u_g − x_c.
ex way(int derivatives) {
  const Letters& s = letters();
  ex result = -centre_displacement(Side::negative).right.subs(s.R * sin(s.alpha) == s.b);
  for (int n = 0; n < derivatives; ++n) result = time_derivative(result, block_rates());
  return result.expand();
}

ex rise(int derivatives) {
  ex result = centre_displacement(Side::negative).up;
  for (int n = 0; n < derivatives; ++n) result = time_derivative(result, block_rates());
  return result.expand();
}

Derivation horizontal(Side side, const Cited& motion) {
  const Letters& s = letters();
  return derived(s.H / s.m, horizontal_reaction(side),
                 {{"C accelerates to the right with", s.u_cddot, centre_acceleration(side).right},
                  {"Newton: H alone accelerates it", s.H, s.m * s.u_cddot},
                  from(motion, "with the angular acceleration from")});
}

Derivation vertical(Side side, const Cited& motion) {
  const Letters& s = letters();
  return derived(s.V / s.m, vertical_reaction(side),
                 {{"C accelerates upwards with", s.y_cddot, centre_acceleration(side).up},
                  {"Newton: V carries the weight and accelerates it", s.V, s.m * (s.g + s.y_cddot)},
                  from(motion, "with the angular acceleration from")});
}

Derivation demand(Side side, const Cited& motion) {
  const Letters& s = letters();
  return derived(
      s.H / s.V, horizontal_reaction(side) / vertical_reaction(side),
      as_before({horizontal(side, motion), vertical(side, motion)}, {in_words("and their ratio")}));
}

Derivation contact(Side side, const Cited& motion) {
  return derived(vertical_reaction(side), 0,
                 {from(vertical(side, motion), "The ground pushes and never pulls")}, {}, ">");
}

// (51): the block at rest, about to move under ü_g = g tan α.
ex at_initiation(const ex& e) {
  const Letters& s = letters();
  return e.subs(lst{s.theta == 0, s.thetadot == 0, s.u_gddot == s.g * sin(s.alpha) / cos(s.alpha)})
      .subs(s.R == 3 * s.g / (4 * pow(s.p, 2)));
}

ex first_ratio() {
  return at_initiation(horizontal_reaction(Side::negative)) /
         at_initiation(vertical_reaction(Side::negative));
}

Given acceleration_at_start() {
  const Derivation start = first_acceleration();
  return {start.left, start.right};
}

}  // namespace

ex horizontal_reaction(Side side) { return with_motion(centre_acceleration(side).right, side); }
ex vertical_reaction(Side side) { return with_motion(letters().g + centre_acceleration(side).up, side); }

Derivation equation_47a() {
  const Letters& s = letters();
  return derived(s.H, s.m * (s.u_gddot - s.x_cddot),
                 {{"Newton, to the right", s.H, s.m * s.u_cddot},
                  {"and by (2), differentiated twice", s.u_cddot, s.u_gddot - s.x_cddot}});
}

Derivation equation_47b() {
  const Letters& s = letters();
  return derived(s.V, s.m * (s.g + s.y_cddot),
                 {in_words("Newton, upwards, as y_c is counted: V − m g = m ÿ_c"),
                  in_words("At t = 0 this is (26), where ÿ_c(0) = −R θ̈(0) sin α")});
}

Derivation equation_48a() {
  return derived(letters().x_c, way(0), {in_words("As in (2)")}, sides_of_the_block());
}
Derivation equation_48b() {
  return derived(letters().x_cdot, way(1), {from(Cited{"48a", equation_48a}, "Differentiate")});
}
Derivation equation_48c() {
  return derived(letters().x_cddot, way(2), {from(Cited{"48b", equation_48b}, "Differentiate")});
}
Derivation equation_49a() { return derived(letters().y_c, rise(0), {in_words("As in (3)")}); }
Derivation equation_49b() {
  return derived(letters().y_cdot, rise(1), {from(Cited{"49a", equation_49a}, "Differentiate")});
}
Derivation equation_49c() {
  return derived(letters().y_cddot, rise(2), {from(Cited{"49b", equation_49b}, "Differentiate")});
}

Derivation horizontal_reaction_negative() { return horizontal(Side::negative, Cited{"21a", equation_21a}); }
Derivation vertical_reaction_negative() { return vertical(Side::negative, Cited{"21a", equation_21a}); }
Derivation friction_demand_negative() { return demand(Side::negative, Cited{"21a", equation_21a}); }
Derivation contact_negative() { return contact(Side::negative, Cited{"21a", equation_21a}); }
Derivation horizontal_reaction_positive() { return horizontal(Side::positive, Cited{"21b", equation_21b}); }
Derivation vertical_reaction_positive() { return vertical(Side::positive, Cited{"21b", equation_21b}); }
Derivation friction_demand_positive() { return demand(Side::positive, Cited{"21b", equation_21b}); }
Derivation contact_positive() { return contact(Side::positive, Cited{"21b", equation_21b}); }

Derivation equation_50a() { return horizontal_reaction_negative(); }
Derivation equation_50b() { return vertical_reaction_negative(); }
Derivation equation_50() { return friction_demand_negative(); }

Derivation equation_50c() {
  const Letters& s = letters();
  Derivation result = derived(
      s.H / s.V, s.mu, {in_words("Coulomb: |H| <= μ V, with V > 0 as long as there is contact")}, {}, "<=");
  result.assumption = "H >= 0; where H < 0 the condition is -H/V <= mu";
  return result;
}

Derivation equation_51a() {
  const Letters& s = letters();
  return derived(
      s.H_0 / s.V_0, first_ratio().normal(),
      {from(friction_demand_negative(), "In"),
       {"put θ = 0, θ̇ = 0 and the acceleration that just suffices", s.u_gddot, s.g * tan(s.alpha)}},
      {acceleration_at_start()});
}

Derivation equation_51b() {
  const Letters& s = letters();
  return derived(s.u_gddot_0 / s.g, first_acceleration().right / s.g,
                 {from(first_acceleration(), "Divide by g")});
}

Derivation equation_51c() {
  const Letters& s = letters();
  return derived(tan(s.alpha), s.mu,
                 {from(Cited{"51a", equation_51a}, "Coulomb, with #"), in_words("which is positive")}, {},
                 "<=");
}

}  // namespace rederive
