#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/sliding.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace paper;

using GiNaC::ex;
using GiNaC::lst;

namespace {

ex with_motion(const ex& e, Side side) { return e.subs(thetaddot == angular_acceleration(side)).expand(); }

// Return a derivative of x_c and y_c of (48) and (49). For θ < 0 the displacement of C is u_c = u_g − x_c.
ex way(int derivatives) {
  ex result = -centre_displacement(Side::negative).right.subs(R * sin(alpha) == b);
  for (int n = 0; n < derivatives; ++n) result = time_derivative(result, block_rates());
  return result.expand();
}

ex rise(int derivatives) {
  ex result = centre_displacement(Side::negative).up;
  for (int n = 0; n < derivatives; ++n) result = time_derivative(result, block_rates());
  return result.expand();
}

Derivation horizontal(Side side, const char* motion) {
  return derived(H / m, horizontal_reaction(side),
                 {{"C accelerates to the right with", u_cddot, centre_acceleration(side).right},
                  {"Newton: H alone accelerates it", H, m * u_cddot},
                  from(motion, "with the angular acceleration from")});
}

Derivation vertical(Side side, const char* motion) {
  return derived(V / m, vertical_reaction(side),
                 {{"C accelerates upwards with", y_cddot, centre_acceleration(side).up},
                  {"Newton: V carries the weight and accelerates it", V, m * (g + y_cddot)},
                  from(motion, "with the angular acceleration from")});
}

Derivation demand(Side side, const char* motion) {
  return derived(
      H / V, horizontal_reaction(side) / vertical_reaction(side),
      as_before({horizontal(side, motion), vertical(side, motion)}, {in_words("and their ratio")}));
}

Derivation contact(Side side, const char* motion) {
  return derived(vertical_reaction(side), 0,
                 {from(vertical(side, motion), "The ground pushes and never pulls")}, {}, ">");
}

// Returns the expression for (51): the block is at rest and about to move under ü_g = g tan α.
ex at_initiation(const ex& e) {
  return e.subs(lst{theta == 0, thetadot == 0, u_gddot == g * sin(alpha) / cos(alpha)})
      .subs(R == 3 * g / (4 * pow(p, 2)));
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
ex vertical_reaction(Side side) { return with_motion(g + centre_acceleration(side).up, side); }

namespace {

Derivation horizontal_reaction_negative() { return horizontal(Side::negative, "21a"); }
Derivation vertical_reaction_negative() { return vertical(Side::negative, "21a"); }
Derivation friction_demand_negative() { return demand(Side::negative, "21a"); }

}  // namespace

// This function is long because it is a list with one entry for each row.
void derive_sliding(Derivations& rows) {
  rows.add("47a", [] {
    return derived(H, m * (u_gddot - x_cddot),
                   {{"Newton, to the right", H, m * u_cddot},
                    {"and by (2), differentiated twice", u_cddot, u_gddot - x_cddot}});
  });
  rows.add("47b", [] {
    return derived(V, m * (g + y_cddot),
                   {in_words("Newton, upwards, as y_c is counted: V − m g = m ÿ_c"),
                    in_words("At t = 0 this is (26), where ÿ_c(0) = −R θ̈(0) sin α")});
  });
  rows.add("48a", [] { return derived(x_c, way(0), {in_words("As in (2)")}, sides_of_the_block()); });
  rows.add("48b", [] { return derived(x_cdot, way(1), {from("48a", "Differentiate")}); });
  rows.add("48c", [] { return derived(x_cddot, way(2), {from("48b", "Differentiate")}); });
  rows.add("49a", [] { return derived(y_c, rise(0), {in_words("As in (3)")}); });
  rows.add("49b", [] { return derived(y_cdot, rise(1), {from("49a", "Differentiate")}); });
  rows.add("49c", [] { return derived(y_cddot, rise(2), {from("49b", "Differentiate")}); });
  rows.add("50a", horizontal_reaction_negative);
  rows.add("50b", vertical_reaction_negative);
  rows.add("50", friction_demand_negative);
  rows.add("50c", [] {
    return assuming(
        derived(H / V, mu, {in_words("Coulomb: |H| <= μ V, with V > 0 as long as there is contact")}, {},
                "<="),
        "H >= 0; where H < 0 the condition is -H/V <= mu");
  });
  rows.add("u17", first_acceleration);
  rows.add("51a", [] {
    return derived(H_0 / V_0, first_ratio().normal(),
                   {from(friction_demand_negative(), "In"),
                    {"put θ = 0, θ̇ = 0 and the acceleration that just suffices", u_gddot, g * tan(alpha)}},
                   {acceleration_at_start()});
  });
  rows.add("51b", [] {
    return derived(u_gddot_0 / g, first_acceleration().right / g,
                   {from(first_acceleration(), "Divide by g")});
  });
  rows.add("51c", [] {
    return derived(tan(alpha), mu, {from("51a", "Coulomb, with #"), in_words("which is positive")}, {}, "<=");
  });
  // Results of our own: the reactions that are right, what friction must bear, and where V > 0 keeps
  // contact
  rows.add("r1", horizontal_reaction_negative);
  rows.add("r2", vertical_reaction_negative);
  rows.add("r3", [] { return horizontal(Side::positive, "21b"); });
  rows.add("r4", [] { return vertical(Side::positive, "21b"); });
  rows.add("r5", friction_demand_negative);
  rows.add("r6", [] { return demand(Side::positive, "21b"); });
  rows.add("r7", [] { return contact(Side::negative, "21a"); });
  rows.add("r8", [] { return contact(Side::positive, "21b"); });
}

}  // namespace rederive::rocking_block
