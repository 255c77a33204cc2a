#include <derivations/rocking_block/linear_response.hpp>
#include <map>

namespace rederive::rocking_block {

using GiNaC::ex;
using GiNaC::lst;

LinearEquation linear_equation_under(Side side, const ex& ground) {
  const ex acceleration = angular_acceleration(side).subs(u_gddot == ground);
  const ex linear = taylor(acceleration, {alpha, theta, a_p}, 1);
  return {p, (linear - pow(p, 2) * theta).expand(), t};
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
  return general_solution(linear_equation(side, pulse), 0, c.C, c.D);
}

Constants forced_constants(Side side, Pulse pulse) {
  static std::map<std::pair<Side, Pulse>, Constants> derived;  // each once
  const auto found = derived.find({side, pulse});
  if (found != derived.end()) return found->second;
  const Constants c = constants_from_start(linear_equation(side, pulse), 0, theta_0, thetadot_0);
  return derived[{side, pulse}] = {with_amplitude(c.C, pulse), with_amplitude(c.D, pulse)};
}

ex linear_response(Side side, Pulse pulse) {
  return solution_from(linear_equation(side, pulse), 0, theta_0, thetadot_0);
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
  return general_solution(linear_equation(side, Pulse::none), t_o, c.C, c.D);
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
  Derivation result =
      derived(thetaddot - pow(equation.k, 2) * theta, equation.forcing,
              {from(exact, "Take"),
               {"with", u_gddot, ground_acceleration(pulse)},
               in_words("to first order in α, θ and α_p/g together: cos is 1, sin is its argument")});
  result.order = 1;
  result.small = "alpha, theta, a_p/g";
  return result;
}

Derivation equation_56a() { return linearised(Side::negative, "21a", Pulse::sine); }
Derivation equation_56b() { return linearised(Side::positive, "21b", Pulse::sine); }

Derivation linear_amplitude() {
  Derivation result =
      derived(a_p / (g * alpha), amplitude(Pulse::sine).value / (g * alpha),
              {from("56a", "At rest and upright, about to move at t = 0, the right side of #"),
               in_words("vanishes; without linearisation tan α stands for α")});
  result.order = 1;
  result.small = "alpha";
  return result;
}

Derivation forced(Side side, const char* equation) {
  const ex particular = particular_solution(linear_equation(side, Pulse::sine));
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

Derivation constant(Side side, bool first, const char* motion, const char* rate) {
  const Constants name = names(side), value = forced_constants(side, Pulse::sine);
  return derived(first ? name.C : name.D, first ? value.C : value.D,
                 {from(motion, "Set t = 0 in"), from(rate, "and in"), in_words("where θ = θ_0, θ̇ = θ̇_0")});
}

// Where the free block of (21) can stand: its weight above the pivot.
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

Derivation equation_61a() { return free_equation(Side::negative, "56a"); }

Derivation free(Side side, const char* equation) {
  return derived(theta, free_motion(side),
                 {from(equation, "Solve #, counting time from t_o"), in_words("sinh, cosh and a constant")});
}

Derivation free_rate(Side side, const char* motion) {
  return derived(
      thetadot / p, (free_motion(side).diff(t) / p).expand(),
      {from(motion, "Differentiate"), in_words("the left side is the angular velocity at t, not at t_o")});
}

Derivation free_constant(Side side, bool first, const char* motion) {
  const Constants name = free_names(side);
  const Constants value =
      constants_from_start(linear_equation(side, Pulse::none), t_o, theta_to, thetadot_to);
  return derived(first ? name.C : name.D, first ? value.C : value.D,
                 {from(motion, "Set t = t_o in"), in_words("and in its derivative")});
}

}  // namespace

Derivation equation_57a() { return forced(Side::negative, "56a"); }
Derivation equation_57b() { return forced(Side::positive, "56b"); }
Derivation equation_59a() { return forced_rate(Side::negative, "57a"); }
Derivation equation_59b() { return forced_rate(Side::positive, "57b"); }

Derivation equation_58a() { return constant(Side::negative, true, "57a", "59a"); }

Derivation equation_58b() { return constant(Side::negative, false, "57a", "59a"); }

Derivation equation_58c() { return constant(Side::positive, true, "57b", "59b"); }

Derivation equation_58d() { return constant(Side::positive, false, "57b", "59b"); }

Derivation equation_61b() { return free_equation(Side::positive, "56b"); }
Derivation equation_62a() { return free(Side::negative, "61a"); }
Derivation equation_62b() { return free(Side::positive, "61b"); }
Derivation equation_64a() { return free_constant(Side::negative, true, "62a"); }
Derivation equation_64b() { return free_constant(Side::negative, false, "62a"); }
Derivation equation_64c() { return free_constant(Side::positive, true, "62b"); }
Derivation equation_64d() { return free_constant(Side::positive, false, "62b"); }

Derivations derivations_of_linear_response() {
  return {
      {"56a", equation_56a},
      {"56b", equation_56b},
      {"57a", equation_57a},
      {"57b", equation_57b},
      {"58a", equation_58a},
      {"58b", equation_58b},
      {"58c", equation_58c},
      {"58d", equation_58d},
      {"59a", equation_59a},
      {"59b", equation_59b},
      {"60a", [] { return critical_angle(Side::positive, alpha); }},
      {"60b", equation_60_rate},
      {"60c", [] { return critical_angle(Side::negative, -alpha); }},
      {"u19a", equation_60_rate},
      {"u19b", [] { return critical_angle(Side::positive, alpha); }},
      {"61a", equation_61a},
      {"61b", equation_61b},
      {"62a", equation_62a},
      {"62b", equation_62b},
      {"63a", [] { return free_rate(Side::negative, "62a"); }},
      {"63b", [] { return free_rate(Side::positive, "62b"); }},
      {"64a", equation_64a},
      {"64b", equation_64b},
      {"64c", equation_64c},
      {"64d", equation_64d},
      {"u21", linear_amplitude},
  };
}

}  // namespace rederive::rocking_block
