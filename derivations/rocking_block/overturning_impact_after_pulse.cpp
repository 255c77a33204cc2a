// Overturning after one impact behind the pulse: (89) to (96), and the window of amplitudes that it leaves.
#include <derivations/rocking_block/overturning_after_one_impact.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::lst;

namespace {

ex at_impact(const ex& e) { return e.subs(letters().t == letters().t_i); }

Given sine_end() { return {letters().T_ex, end_of_pulse(Pulse::sine)}; }

}  // namespace

ex scaled_rate_at_end() {
  const Letters& s = letters();
  return (rate_at_end(Side::negative, Pulse::sine).subs(constants_from_rest()) / s.alpha).expand();
}

ex scaled_angle_at_end() {
  const Letters& s = letters();
  return ((angle_at_end(Side::negative, Pulse::sine).subs(constants_from_rest()) + s.alpha) / s.alpha)
      .expand();
}

namespace {

// The free motion (89) from the state (91): θ + α over α, and θ̇ over p α.
LinearEquation free_equation() { return linear_equation(Side::negative, Pulse::none); }

ex free_from_end() {
  const Letters& s = letters();
  return solution_from(free_equation(), s.T_ex, s.theta_ex, s.thetadot_ex);
}

ex from_state_at_end(const ex& e) {
  const Letters& s = letters();
  return e.subs(lst{s.theta_ex == s.alpha * (scaled_angle_at_end() - 1),
                    s.thetadot_ex == s.alpha * s.p * scaled_rate_at_end()});
}

}  // namespace

ex impact_after_pulse() {
  const Letters& s = letters();
  return (from_state_at_end(at_impact(free_from_end())) / s.alpha).expand();
}

ex overturning_impact_after_pulse() {
  const Letters& s = letters();
  const ex rate = from_state_at_end(at_impact(free_from_end().diff(s.t)));
  return (s.e * rate / (s.p * s.alpha) - 1).expand();
}

Derivation equation_89a() {
  return derived(letters().theta, free_from_end(),
                 {from(Cited{"62a", equation_62a}, "Free motion # from T_ex:"),
                  from(Cited{"66a", equation_66a}, "with"), from(Cited{"66b", equation_66b}, "and")});
}

Derivation equation_89b() {
  const Letters& s = letters();
  return derived(s.thetadot / s.p, (free_from_end().diff(s.t) / s.p).expand(),
                 {from(Cited{"89a", equation_89a}, "Differentiate")});
}

Derivation equation_90a() { return equation_70a(); }
Derivation equation_90b() { return equation_70b(); }

Derivation equation_91a() {
  const Letters& s = letters();
  return derived(s.theta_ex, s.alpha * scaled_angle_at_end() - s.alpha,
                 {from(Cited{"69a", equation_69a}, "Into"), from(Cited{"70a", equation_70a}, "put"),
                  from(Cited{"70b", equation_70b}, "and")});
}

Derivation equation_91b() {
  const Letters& s = letters();
  return derived(s.thetadot_ex / s.p, (s.alpha * scaled_rate_at_end()).expand(),
                 {from(Cited{"69b", equation_69b}, "Into"), from(Cited{"70a", equation_70a}, "put"),
                  from(Cited{"70b", equation_70b}, "and")});
}

Derivation equation_92a() {
  return derived(impact_after_pulse() + 1, 1,
                 {from(Cited{"89a", equation_89a}, "At t_i the block is upright: in #"),
                  from(Cited{"91a", equation_91a}, "put"), from(Cited{"91b", equation_91b}, "and"),
                  in_words("and divide by α")});
}

Derivation equation_92b() {
  const Letters& s = letters();
  return derived(s.thetadot_before, from_state_at_end(at_impact(free_from_end().diff(s.t))).expand(),
                 {from(Cited{"89b", equation_89b}, "At t_i, in #"), from(Cited{"91a", equation_91a}, "put"),
                  from(Cited{"91b", equation_91b}, "and")});
}

namespace {

ex free_after_impact() {
  const Letters& s = letters();
  return general_solution(linear_equation(Side::positive, Pulse::none), s.t_i, s.c_1, s.c_2);
}

Constants free_constants_after_impact() {
  const Letters& s = letters();
  return constants_from_start(linear_equation(Side::positive, Pulse::none), s.t_i, 0, s.thetadot_after);
}

ex at_corner(const ex& e) {
  const Letters& s = letters();
  const Constants c = free_constants_after_impact();
  return e.subs(lst{s.c_1 == c.C, s.c_2 == c.D, s.t == s.t_star});
}

// c_1 + c_2: what decides the free motion after the impact.
ex growth_after_impact() {
  const Letters& s = letters();
  const Constants c = free_constants_after_impact();
  return 2 * growing_part(free_after_impact(), s.t_i).subs(lst{s.c_1 == c.C, s.c_2 == c.D});
}

}  // namespace

Derivation equation_93a() {
  return derived(letters().theta, free_after_impact(),
                 {from(Cited{"61b", equation_61b}, "Solve #, counting time from t_i")});
}

Derivation equation_93b() {
  const Letters& s = letters();
  return derived(s.thetadot / s.p, (free_after_impact().diff(s.t) / s.p).expand(),
                 {from(Cited{"93a", equation_93a}, "Differentiate")});
}

Derivation second_constant_after_impact() {
  return derived(letters().c_2, free_constants_after_impact().D,
                 {from(Cited{"93a", equation_93a}, "At t_i the block is upright: by #")});
}

Derivation first_constant_after_impact() {
  return derived(letters().c_1, free_constants_after_impact().C,
                 {from(Cited{"93b", equation_93b}, "At t_i, just after the impact, by #")});
}

Derivation first_constant_by_restitution() {
  const Letters& s = letters();
  return derived(s.thetadot_after / s.p,
                 free_constants_after_impact().C.subs(s.thetadot_after == s.e * s.thetadot_before),
                 {from(first_constant_after_impact(), "With"),
                  {"by the impact", s.thetadot_after, s.e * s.thetadot_before}});
}

Derivation equation_94a() {
  const Letters& s = letters();
  return derived(at_corner(free_after_impact()) - s.alpha, 0,
                 {from(Cited{"93a", equation_93a}, "At t* the block is to stand on its corner: by #"),
                  from(first_constant_after_impact(), "with"), from(second_constant_after_impact(), "and"),
                  in_words("the velocity in it is the one after the impact")});
}

Derivation equation_94b() {
  const Letters& s = letters();
  return derived(at_corner(free_after_impact().diff(s.t) / s.p).expand(), 0,
                 {from(Cited{"93b", equation_93b}, "and to be at rest there: by #"),
                  in_words("the velocity in it is the one after the impact")});
}

Derivation equation_95a() {
  const Letters& s = letters();
  return derived(
      (s.p * growth_after_impact()).expand(), 0,
      {from(Cited{"94a", equation_94a}, "At no finite time do"), from(Cited{"94b", equation_94b}, "and"),
       in_words("hold together: the corner is approached without end, when the part of (93a) that grows "
                "is absent, c_1 + c_2 = 0")});
}

Derivation equation_95b() {
  const Letters& s = letters();
  return derived(
      (s.p * growth_after_impact()).expand().subs(s.thetadot_after == s.e * s.thetadot_before), 0,
      {from(Cited{"95a", equation_95a}, "With the impact"), {"", s.thetadot_after, s.e * s.thetadot_before}});
}

Derivation equation_96() {
  return derived(overturning_impact_after_pulse() + 1, 1,
                 {from(Cited{"95b", equation_95b}, "Into"), from(Cited{"92b", equation_92b}, "put"),
                  in_words("and divide by p α")});
}

namespace {

ex energy_at_end() { return (pow(scaled_rate_at_end(), 2) - pow(scaled_angle_at_end(), 2)); }

// θ̇²/p² − (θ + α)² keeps its value in free motion; at an upright block it is θ̇²/p² − α².
ex energy_at_critical_impact() {
  const Letters& s = letters();
  const ex rate = s.alpha / s.e;  // e θ̇/p = α
  return ((pow(rate, 2) - pow(s.alpha, 2)) / pow(s.alpha, 2)).expand();
}

std::vector<Step> elimination() {
  return {
      from(Cited{"92a", equation_92a}, "Between"),
      from(Cited{"96", equation_96}, "and"),
      in_words("t_i drops out: θ̇²/p² − (θ + α)² does not change in free motion, neither from T_ex to t_i"),
      {"At the end of the pulse it is, over α²,", energy_at_end(), energy_at_end()},
      {"and at an impact after which the corner is just reached", energy_at_critical_impact(),
       energy_at_critical_impact()}};
}

}  // namespace

Derivation window_after_pulse() {
  return derived(energy_at_end(), energy_at_critical_impact(), elimination(), {sine_end()});
}

Derivation overturns_after_pulse() {
  std::vector<Step> steps = elimination();
  steps.push_back(in_words("A faster impact overturns, a slower one does not"));
  return derived(energy_at_end(), energy_at_critical_impact(), std::move(steps), {sine_end()}, ">");
}

Derivation time_of_critical_impact() {
  const Letters& s = letters();
  const ex growth = exp(s.p * (s.t_i - s.T_ex));
  return derived(
      (scaled_rate_at_end() + scaled_angle_at_end()) * growth, 1 + 1 / s.e,
      {from(Cited{"92a", equation_92a}, "Add"), from(Cited{"96", equation_96}, "# divided by e to"),
       in_words("sinh and cosh join. The impact is behind the pulse if the factor of the exponential is "
                "at most 1 + 1/e")},
      {sine_end()});
}

Derivation velocity_near_first_mode() {
  const Letters& s = letters();
  // θ̇(T_ex) = −p (θ(T_ex) + α) by (68): the block that just comes back has left its corner from rest.
  const ex square = pow(s.thetadot_ex / s.p, 2) - pow(s.theta_ex + s.alpha, 2) + pow(s.alpha, 2);
  const ex critical = square.subs(s.thetadot_ex == -s.p * (s.theta_ex + s.alpha)).expand();
  return derived(
      s.thetadot_before, s.p * sqrt(critical),
      {from(Cited{"68", equation_68}, "At the threshold without impact"),
       {"the impact of free motion from there has", pow(s.thetadot_before / s.p, 2), square},
       in_words("so e θ̇ < p α after it, and by (95b) the block does not overturn: below (71) comes a "
                "range of amplitudes that are safe")});
}

}  // namespace rederive
