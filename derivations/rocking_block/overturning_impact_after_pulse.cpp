// Overturning after one impact after the end of the pulse: (89) to (96), and the window of amplitudes for it.
#include <derivations/rocking_block/overturning_after_one_impact.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace paper;

using GiNaC::ex;
using GiNaC::lst;

namespace {

Given sine_end() { return {T_ex, end_of_pulse(Pulse::sine)}; }

ex scaled_rate_at_end() {
  return (rate_at_end(Side::negative, Pulse::sine).subs(constants_from_rest()) / alpha).expand();
}

ex scaled_angle_at_end() {
  return ((angle_at_end(Side::negative, Pulse::sine).subs(constants_from_rest()) + alpha) / alpha).expand();
}

// The free motion (89) starts from the state (91): (θ + α)/α and θ̇/(p α).
LinearEquation free_equation() { return linear_equation(Side::negative, Pulse::none); }

ex free_from_end() { return solution(free_equation(), from_start(T_ex, theta_ex, thetadot_ex)).value; }

ex from_state_at_end(const ex& e) {
  return e.subs(
      lst{theta_ex == alpha * (scaled_angle_at_end() - 1), thetadot_ex == alpha * p * scaled_rate_at_end()});
}

}  // namespace

ex impact_after_pulse() { return (from_state_at_end(at_impact(free_from_end())) / alpha).expand(); }

ex overturning_impact_after_pulse() {
  const ex rate = from_state_at_end(at_impact(free_from_end().diff(t)));
  return (e * rate / (p * alpha) - 1).expand();
}

namespace {

ex free_after_impact() {
  return general_solution(linear_equation(Side::positive, Pulse::none), t_i, c_1, c_2).value;
}

Constants free_constants_after_impact() {
  return solution(linear_equation(Side::positive, Pulse::none), from_start(t_i, 0, thetadot_after)).constants;
}

ex at_corner(const ex& e) {
  const Constants c = free_constants_after_impact();
  return e.subs(lst{c_1 == c.C, c_2 == c.D, t == t_star});
}

// Returns c_1 + c_2, whose sign decides the free motion after the impact.
ex growth_after_impact() {
  const Constants c = free_constants_after_impact();
  return 2 * growing_part(free_after_impact(), t_i).subs(lst{c_1 == c.C, c_2 == c.D});
}

Derivation second_constant_after_impact() {
  return derived(c_2, free_constants_after_impact().D, {from("93a", "At t_i the block is upright: by #")});
}

Derivation first_constant_after_impact() {
  return derived(c_1, free_constants_after_impact().C, {from("93b", "At t_i, just after the impact, by #")});
}

ex energy_at_end() { return (pow(scaled_rate_at_end(), 2) - pow(scaled_angle_at_end(), 2)); }

// Returns θ̇²/p² − (θ + α)², over α², at the critical impact. It is constant in free motion, and θ̇²/p² − α²
// when the block is upright.
ex energy_at_critical_impact() {
  const ex rate = alpha / e;  // e θ̇/p = α
  return ((pow(rate, 2) - pow(alpha, 2)) / pow(alpha, 2)).expand();
}

std::vector<Step> elimination() {
  return {
      from("92a", "Between"),
      from("96", "and"),
      in_words("t_i drops out: θ̇²/p² − (θ + α)² does not change in free motion, neither from T_ex to t_i"),
      {"At the end of the pulse it is, over α²,", energy_at_end(), energy_at_end()},
      {"and at an impact after which the corner is just reached", energy_at_critical_impact(),
       energy_at_critical_impact()}};
}

}  // namespace

Derivation time_of_critical_impact() {
  const ex growth = exp(p * (t_i - T_ex));
  return derived(
      (scaled_rate_at_end() + scaled_angle_at_end()) * growth, 1 + 1 / e,
      {from("92a", "Add"), from("96", "# divided by e to"),
       in_words("sinh and cosh join. The impact is behind the pulse if the factor of the exponential is "
                "at most 1 + 1/e")},
      {sine_end()});
}

// This function is long because it is a list with one entry for each row.
void derive_overturning_impact_after_pulse(Derivations& rows) {
  rows.add("89a", [] {
    return derived(theta, free_from_end(),
                   {from("62a", "Free motion # from T_ex:"), from("66a", "with"), from("66b", "and")});
  });
  rows.add("89b", [] {
    return derived(thetadot / p, (free_from_end().diff(t) / p).expand(), {from("89a", "Differentiate")});
  });
  rows.add("90a", equation_70a);
  rows.add("90b", equation_70b);
  rows.add("91a", [] {
    return derived(theta_ex, alpha * scaled_angle_at_end() - alpha,
                   {from("69a", "Into"), from("70a", "put"), from("70b", "and")});
  });
  rows.add("91b", [] {
    return derived(thetadot_ex / p, (alpha * scaled_rate_at_end()).expand(),
                   {from("69b", "Into"), from("70a", "put"), from("70b", "and")});
  });
  rows.add("92a", [] {
    return derived(impact_after_pulse() + 1, 1,
                   {from("89a", "At t_i the block is upright: in #"), from("91a", "put"), from("91b", "and"),
                    in_words("and divide by α")});
  });
  rows.add("92b", [] {
    return derived(thetadot_before, from_state_at_end(at_impact(free_from_end().diff(t))).expand(),
                   {from("89b", "At t_i, in #"), from("91a", "put"), from("91b", "and")});
  });
  rows.add("93a", [] {
    return derived(theta, free_after_impact(), {from("61b", "Solve #, counting time from t_i")});
  });
  rows.add("93b", [] {
    return derived(thetadot / p, (free_after_impact().diff(t) / p).expand(), {from("93a", "Differentiate")});
  });
  rows.add("u24", second_constant_after_impact);
  rows.add("u25a", first_constant_after_impact);
  rows.add("u25b", [] {
    return derived(thetadot_after / p,
                   free_constants_after_impact().C.subs(thetadot_after == e * thetadot_before),
                   {from(first_constant_after_impact(), "With"),
                    {"by the impact", thetadot_after, e * thetadot_before}});
  });
  rows.add("94a", [] {
    return derived(at_corner(free_after_impact()) - alpha, 0,
                   {from("93a", "At t_star the block is to stand on its corner: by #"),
                    from(first_constant_after_impact(), "with"), from(second_constant_after_impact(), "and"),
                    in_words("the velocity in it is the one after the impact")});
  });
  rows.add("94b", [] {
    return derived(at_corner(free_after_impact().diff(t) / p).expand(), 0,
                   {from("93b", "and to be at rest there: by #"),
                    in_words("the velocity in it is the one after the impact")});
  });
  rows.add("95a", [] {
    return derived(
        (p * growth_after_impact()).expand(), 0,
        {from("94a", "At no finite time do"), from("94b", "and"),
         in_words("hold together: the corner is approached without end, when the part of (93a) that grows "
                  "is absent, c_1 + c_2 = 0")});
  });
  rows.add("95b", [] {
    return derived((p * growth_after_impact()).expand().subs(thetadot_after == e * thetadot_before), 0,
                   {from("95a", "With the impact"), {"", thetadot_after, e * thetadot_before}});
  });
  rows.add("96", [] {
    return derived(overturning_impact_after_pulse() + 1, 1,
                   {from("95b", "Into"), from("92b", "put"), in_words("and divide by p α")});
  });
  // Results of our own: the window of amplitudes that overturn, and the impact at its ends
  rows.add("r9",
           [] { return derived(energy_at_end(), energy_at_critical_impact(), elimination(), {sine_end()}); });
  rows.add("r10", [] {
    std::vector<Step> steps = elimination();
    steps.push_back(in_words("A faster impact overturns, a slower one does not"));
    return derived(energy_at_end(), energy_at_critical_impact(), std::move(steps), {sine_end()}, ">");
  });
  rows.add("r11", time_of_critical_impact);
  rows.add("r12", [] {
    // By (68) θ̇(T_ex) = −p (θ(T_ex) + α) for the block that just comes back.
    const ex square = pow(thetadot_ex / p, 2) - pow(theta_ex + alpha, 2) + pow(alpha, 2);
    const ex critical = square.subs(thetadot_ex == -p * (theta_ex + alpha)).expand();
    return derived(
        thetadot_before, p * sqrt(critical),
        {from("68", "At the threshold without impact"),
         {"the impact of free motion from there has", pow(thetadot_before / p, 2), square},
         in_words("so e θ̇ < p α after it, and by (95b) the block does not overturn: below (71) comes a "
                  "range of amplitudes that are safe")});
  });
}

}  // namespace rederive::rocking_block
