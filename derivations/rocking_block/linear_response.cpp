#include <derivations/rocking_block/linear_response.hpp>
#include <map>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace paper;

using GiNaC::ex;
using GiNaC::lst;

LinearEquation linear_equation_under(Side side, const ex& ground) {
  const ex acceleration = angular_acceleration(side).subs(u_gddot == ground);
  const ex linear = taylor(acceleration, {alpha, theta, a_p}, 1);
  const ex stiffness = -linear.coeff(theta, 1);
  return {1, 0, stiffness, (linear + stiffness * theta).expand(), t};
}

LinearEquation linear_equation(Side side, Pulse pulse) {
  static std::map<std::pair<Side, Pulse>, LinearEquation> derived;  // each once
  const auto found = derived.find({side, pulse});
  if (found != derived.end()) return found->second;
  return derived[{side, pulse}] = linear_equation_under(side, ground_acceleration(pulse));
}

Given amplitude(Pulse pulse) {
  const ex at_rest = linear_equation(Side::negative, pulse).forcing.subs(t == 0);
  return {a_p, -at_rest.coeff(a_p, 0) / at_rest.coeff(a_p, 1)};
}

Constants free_names(Side side) {
  return side == Side::negative ? Constants{Abar_1, Abar_2} : Constants{Abar_3, Abar_4};
}

ex with_amplitude(const ex& e, Pulse pulse) {
  const Given a = amplitude(pulse);
  return e.subs(a.name == a.value);
}

namespace {

Constants names(Side side) { return side == Side::negative ? Constants{A_1, A_2} : Constants{A_3, A_4}; }

}  // namespace

ex forced_motion(Side side, Pulse pulse) {
  const Constants c = names(side);
  return general_solution(linear_equation(side, pulse), 0, c.C, c.D).value;
}

Constants forced_constants(Side side, Pulse pulse) {
  static std::map<std::pair<Side, Pulse>, Constants> derived;  // each once
  const auto found = derived.find({side, pulse});
  if (found != derived.end()) return found->second;
  const Constants c = solution(linear_equation(side, pulse), from_start(0, theta_0, thetadot_0)).constants;
  return derived[{side, pulse}] = {with_amplitude(c.C, pulse), with_amplitude(c.D, pulse)};
}

ex linear_response(Side side, Pulse pulse) {
  return solution(linear_equation(side, pulse), from_start(0, theta_0, thetadot_0)).value;
}

ex by_half_phases(const ex& response) {
  const ex circular = omega_p * t, real = p * t;
  const GiNaC::symbol sine("sine"), cosine("cosine"), hyperbolic_sine("sh"), hyperbolic_cosine("ch");
  const lst double_phases{sin(circular) == 2 * sine * cosine, cos(circular) == 1 - 2 * pow(sine, 2),
                          sinh(real) == 2 * hyperbolic_sine * hyperbolic_cosine,
                          cosh(real) == 1 + 2 * pow(hyperbolic_sine, 2)};
  const ex sum = sin(psi) * cos(circular) + cos(psi) * sin(circular);
  const lst functions{sine, cosine, hyperbolic_sine, hyperbolic_cosine};
  const ex collected =
      response.subs(sin(circular + psi) == sum).subs(double_phases).expand().collect(functions, true);
  GiNaC::exmap coefficients;  // of each product of functions, so that what cancels in them does
  for (const ex& term : collected) {
    ex function = 1;
    for (const ex& f : functions) function *= pow(f, term.degree(f));
    coefficients[function] += term / function;
  }
  ex halved = 0;
  for (const auto& [function, coefficient] : coefficients) halved += coefficient.normal() * function;
  return halved.subs(lst{sine == sin(circular / 2), cosine == cos(circular / 2),
                         hyperbolic_sine == sinh(real / 2), hyperbolic_cosine == cosh(real / 2)});
}

ex free_motion(Side side) {
  const Constants c = free_names(side);
  return general_solution(linear_equation(side, Pulse::none), t_o, c.C, c.D).value;
}

ex growing_part(const ex& free_motion, const ex& start) {
  const GiNaC::symbol growth("growth");
  const ex phase = p * (t - start);
  const ex in_growth = free_motion.subs(
      lst{sinh(phase) == (growth - 1 / ex(growth)) / 2, cosh(phase) == (growth + 1 / ex(growth)) / 2});
  return in_growth.expand().coeff(growth, 1);
}

namespace {

Derivation linearised(Side side, const char* exact, Pulse pulse) {
  const LinearEquation equation = linear_equation(side, pulse);
  return to_order(
      derived(thetaddot + equation.stiffness * theta, equation.forcing,
              {from(exact, "Take"),
               {"with", u_gddot, ground_acceleration(pulse)},
               in_words("to first order in α, θ and α_p/g together: cos is 1, sin is its argument")}),
      1, "alpha, theta, a_p/g");
}

Derivation linear_amplitude() {
  return to_order(derived(a_p / (g * alpha), amplitude(Pulse::sine).value / (g * alpha),
                          {from("56a", "At rest and upright, about to move at t = 0, the right side of #"),
                           in_words("vanishes; without linearisation tan α stands for α")}),
                  1, "alpha");
}

Derivation forced(Side side, const char* equation) {
  const ex particular = particular_solution(linear_equation(side, Pulse::sine)).value;
  return derived(
      theta, forced_motion(side, Pulse::sine),
      {from(equation, "Solve"),
       {"undetermined coefficients: a constant, sin(ω_p t + ψ) and cos(ω_p t + ψ) give the solution", theta,
        particular},
       in_words("and sinh p t, cosh p t solve the equation without its right side")});
}

Derivation forced_rate(Side side, const char* motion) {
  const ex rate = forced_motion(side, Pulse::sine).diff(t);
  return derived(thetadot / p, (with_amplitude(rate, Pulse::sine) / p).expand(),
                 {from(motion, "Differentiate"), from(linear_amplitude(), "and put in the amplitude")});
}

// Derives the angle at which the free block of (21) is in equilibrium, with its weight above the pivot.
Derivation critical_angle(Side side, const ex& value) {
  const ex weight = angular_acceleration(side).subs(u_gddot == 0);
  return derived(
      theta_star, value,
      {{"After the pulse the block accelerates with", thetaddot, weight},
       {"which vanishes, between lying down and standing, where the weight is above the pivot", theta, value},
       in_words("an equilibrium that a disturbance leaves: the critical motion ends there")});
}

Derivation equation_60_rate() {
  return derived(
      thetadot_star, 0,
      {in_words("The critical motion neither falls over nor comes back: it ends in that equilibrium, "
                "which it approaches without end as t_star grows")});
}

Derivation free_equation(Side side, const char* forced_equation) {
  return derived(thetaddot - pow(p, 2) * theta, linear_equation(side, Pulse::none).forcing,
                 {from(forced_equation, "Let the ground rest in")});
}

Derivation free(Side side, const char* equation) {
  return derived(theta, free_motion(side),
                 {from(equation, "Solve #, counting time from t_o"), in_words("sinh, cosh and a constant")});
}

Derivation free_rate(Side side, const char* motion) {
  return derived(
      thetadot / p, (free_motion(side).diff(t) / p).expand(),
      {from(motion, "Differentiate"), in_words("the left side is the angular velocity at t, not at t_o")});
}

}  // namespace

Derivation forced_constant(Side side, bool first) {
  const bool is_left = side == Side::negative;
  const Constants name = names(side), value = forced_constants(side, Pulse::sine);
  return derived(first ? name.C : name.D, first ? value.C : value.D,
                 {from(is_left ? "57a" : "57b", "Set t = 0 in"), from(is_left ? "59a" : "59b", "and in"),
                  in_words("where θ = θ_0, θ̇ = θ̇_0")});
}

Derivation free_constant(Side side, bool first) {
  const Constants name = free_names(side);
  const Constants value =
      solution(linear_equation(side, Pulse::none), from_start(t_o, theta_to, thetadot_to)).constants;
  return derived(
      first ? name.C : name.D, first ? value.C : value.D,
      {from(side == Side::negative ? "62a" : "62b", "Set t = t_o in"), in_words("and in its derivative")});
}

// This function is long because it is a list with one entry for each row.
void derive_linear_response(Derivations& rows) {
  rows.add("56a", [] { return linearised(Side::negative, "21a", Pulse::sine); });
  rows.add("56b", [] { return linearised(Side::positive, "21b", Pulse::sine); });
  rows.add("57a", [] { return forced(Side::negative, "56a"); });
  rows.add("57b", [] { return forced(Side::positive, "56b"); });
  rows.add("58a", [] { return forced_constant(Side::negative, true); });
  rows.add("58b", [] { return forced_constant(Side::negative, false); });
  rows.add("58c", [] { return forced_constant(Side::positive, true); });
  rows.add("58d", [] { return forced_constant(Side::positive, false); });
  rows.add("59a", [] { return forced_rate(Side::negative, "57a"); });
  rows.add("59b", [] { return forced_rate(Side::positive, "57b"); });
  rows.add("60a", [] { return critical_angle(Side::positive, alpha); });
  rows.add("60b", equation_60_rate);
  rows.add("60c", [] { return critical_angle(Side::negative, -alpha); });
  rows.add("u19a", equation_60_rate);
  rows.add("u19b", [] { return critical_angle(Side::positive, alpha); });
  rows.add("61a", [] { return free_equation(Side::negative, "56a"); });
  rows.add("61b", [] { return free_equation(Side::positive, "56b"); });
  rows.add("62a", [] { return free(Side::negative, "61a"); });
  rows.add("62b", [] { return free(Side::positive, "61b"); });
  rows.add("63a", [] { return free_rate(Side::negative, "62a"); });
  rows.add("63b", [] { return free_rate(Side::positive, "62b"); });
  rows.add("64a", [] { return free_constant(Side::negative, true); });
  rows.add("64b", [] { return free_constant(Side::negative, false); });
  rows.add("64c", [] { return free_constant(Side::positive, true); });
  rows.add("64d", [] { return free_constant(Side::positive, false); });
  rows.add("u21", linear_amplitude);
}

}  // namespace rederive::rocking_block
