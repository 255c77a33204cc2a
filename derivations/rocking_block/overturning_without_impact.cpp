#include <derivations/rocking_block/overturning_without_impact.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace paper;

using GiNaC::ex;
using GiNaC::lst;

namespace {

ex corner(Side side) { return side == Side::negative ? ex(-alpha) : ex(alpha); }

// Returns the free motion from the end of the pulse on.
ex free_from_end(Side side) { return free_motion(side).subs(t_o == T_ex); }

// Returns the expression at T_ex, where the phase is a multiple of π/2, whose sine and cosine GiNaC knows.
ex at_end(const ex& e, Pulse pulse) {
  const ex phase = omega_p * end_of_pulse(pulse) + psi;
  return e.subs(omega_p * t + psi == phase.expand()).subs(t == T_ex);
}

}  // namespace

ex by_phase(const ex& e) { return e.normal().expand().collect(lst{cos(psi), sin(psi)}, true); }

ex in_exponentials(const ex& e) {
  const ex any = GiNaC::wild();
  return e.subs(lst{sinh(any) == (exp(any) - exp(-any)) / 2, cosh(any) == (exp(any) + exp(-any)) / 2});
}

lst constants_from_rest() {
  const Constants c = forced_constants(Side::negative, Pulse::sine);
  const lst rest{theta_0 == 0, thetadot_0 == 0};
  return lst{A_1 == c.C.subs(rest).normal(), A_2 == c.D.subs(rest).normal()};
}

ex critical_sum(Side side, const ex& angle, const ex& rate) { return rate / p + angle - corner(side); }

ex linear_critical_rate(Side side) { return -p * critical_sum(side, theta, 0); }

ex linear_impact_rate_squared(Side side) {
  // 2 θ̇ times θ̈ − p²θ = f says that θ̇² − p²(θ − θ_c)², a product of two factors, is constant, with p²θ_c =
  // −f.
  const LinearEquation equation = linear_equation(side, Pulse::none);
  const ex from_corner = p * (theta - equation.forcing / equation.stiffness).normal();
  const ex kept = (thetadot - from_corner) * (thetadot + from_corner);
  return kept - kept.subs(lst{theta == 0, thetadot == 0});
}

ex angle_at_end(Side side, Pulse pulse) { return at_end(forced_motion(side, pulse), pulse); }

ex rate_at_end(Side side, Pulse pulse) {
  const ex rate = with_amplitude(forced_motion(side, pulse).diff(t), pulse);
  return (at_end(rate, pulse) / p).expand();
}

ThresholdEquation threshold_without_impact(Side side, const ex& ground, const Given& amplitude,
                                           const ex& end) {
  const GiNaC::symbol growth("growth");  // e^{p t} at the end of the pulse
  const ex motion = solution(linear_equation_under(side, ground), from_start(0, theta_0, thetadot_0)).value;
  const ex sum = critical_sum(side, motion, motion.diff(t)).subs(amplitude.name == amplitude.value);
  const ex at_end = in_exponentials(sum)
                        .subs(lst{exp(p * t) == growth, exp(-p * t) == 1 / ex(growth)})
                        .subs(t == end)
                        .expand();
  // The sum is grown·e^{p T_ex} + added. It is divided so that e^{−p T_ex} is alone on the right.
  const ex grown = at_end.coeff(growth, 1), added = at_end.coeff(growth, 0);
  return {by_phase(-grown / added), exp(-p * end)};
}

ThresholdEquation threshold_without_impact(Side side, Pulse pulse) {
  return threshold_without_impact(side, ground_acceleration(pulse), amplitude(pulse), end_of_pulse(pulse));
}

namespace {

// Derive φ = corner and φ̇ = 0 for the free motion after T_ex: (65), (72).
Derivation corner_reached(Side side, const char* motion) {
  return derived(corner(side), free_from_end(side),
                 {from(motion, "The motion # after the pulse, t_o = T_ex,"),
                  {"reaches the corner", theta, corner(side)}});
}

Derivation corner_at_rest(Side side, const char* motion) {
  return derived(
      0, (free_from_end(side).diff(t) / p).expand(),
      {from(motion, "The motion # after the pulse, t_o = T_ex,"), in_words("comes there without velocity")});
}

Derivation constant_at_end(const char* id, const Derivation& free_constant) {
  const auto at_end = lst{t_o == T_ex, theta_to == theta_ex, thetadot_to == thetadot_ex};
  return derived(free_constant.left, free_constant.right.subs(at_end),
                 {from(id, "Free motion begins at t_o = T_ex; so by #")});
}

Derivation no_growth(Side side, const char* motion) {
  const Constants c = free_names(side);
  const ex growing = growing_part(free_from_end(side), T_ex);
  return derived(
      c.C, c.C - 2 * growing,
      {from(motion, "Write with exponentials"),
       {"the part that grows like e^{p(t − T_ex)} has the factor", growing, 0},
       in_words("If it is not zero the block falls over or comes back; at no finite time do both (65a) "
                "and (65b), or (72a) and (72b), hold: the corner is reached as t grows without end")});
}

Derivation critical(Side side, const char* condition, const char* first, const char* second) {
  return derived((p * critical_sum(side, theta_ex, thetadot_ex)).expand(), 0,
                 {from(condition, "Into"), from(first, "put"), from(second, "and")});
}

Derivation end_angle(Side side, const char* motion) {
  return derived(theta_ex, angle_at_end(side, Pulse::sine),
                 {from(motion, "At T_ex the phase of the pulse is 2π, and its sine 0: by #")});
}

Derivation end_rate(Side side, const char* rate) {
  return derived(thetadot_ex / p, rate_at_end(side, Pulse::sine),
                 {from(rate, "At T_ex the phase of the pulse is 2π, and its cosine 1: by #")});
}

Derivation from_rest(const char* id, const Derivation& constant) {
  return derived(constant.left, constant.right.subs(lst{theta_0 == 0, thetadot_0 == 0}).normal(),
                 {from(id, "From rest, θ_0 = θ̇_0 = 0: by #")});
}

Derivation threshold(Side side, const std::vector<const char*>& ingredients) {
  const ThresholdEquation found = threshold_without_impact(side, Pulse::sine);
  std::vector<Step> steps;
  for (const char* id : ingredients)
    steps.push_back(from(id, steps.empty() ? "Into" : steps.size() == 1 ? "put" : "and"));
  steps.push_back(from(end_of_sine_pulse(), "where"));
  steps.push_back(in_words("sinh and cosh join to exponentials; divide by the factor of e^{−p T_ex}"));
  return derived(by_phase(found.left.subs(lst{theta_0 == 0, thetadot_0 == 0})), found.right, steps);
}

}  // namespace

Derivation equation_68() { return critical(Side::negative, "67", "66a", "66b"); }

Derivation equation_70a() { return from_rest("58a", forced_constant(Side::negative, true)); }
Derivation equation_70b() { return from_rest("58b", forced_constant(Side::negative, false)); }

// This function is long because it is a list with one entry for each row.
void derive_overturning_without_impact(Derivations& rows) {
  rows.add("65a", [] { return corner_reached(Side::negative, "62a"); });
  rows.add("65b", [] { return corner_at_rest(Side::negative, "62a"); });
  rows.add("66a", [] { return constant_at_end("64a", free_constant(Side::negative, true)); });
  rows.add("66b", [] { return constant_at_end("64b", free_constant(Side::negative, false)); });
  rows.add("67", [] { return no_growth(Side::negative, "62a"); });
  rows.add("68", equation_68);
  rows.add("69a", [] { return end_angle(Side::negative, "57a"); });
  rows.add("69b", [] { return end_rate(Side::negative, "59a"); });
  rows.add("70a", equation_70a);
  rows.add("70b", equation_70b);
  rows.add("71", [] { return threshold(Side::negative, {"68", "69a", "69b", "70a", "70b"}); });
  rows.add("72a", [] { return corner_reached(Side::positive, "62b"); });
  rows.add("72b", [] { return corner_at_rest(Side::positive, "62b"); });
  rows.add("73a", [] { return constant_at_end("64c", free_constant(Side::positive, true)); });
  rows.add("73b", [] { return constant_at_end("64d", free_constant(Side::positive, false)); });
  rows.add("74", [] { return no_growth(Side::positive, "62b"); });
  rows.add("75", [] { return critical(Side::positive, "74", "73a", "73b"); });
  rows.add("76a", [] { return end_angle(Side::positive, "57b"); });
  rows.add("76b", [] { return end_rate(Side::positive, "59b"); });
  rows.add("77a", [] { return from_rest("58c", forced_constant(Side::positive, true)); });
  rows.add("77b", [] { return from_rest("58d", forced_constant(Side::positive, false)); });
  rows.add("78", [] { return threshold(Side::positive, {"75", "76a", "76b", "77a", "77b"}); });
}

}  // namespace rederive::rocking_block
