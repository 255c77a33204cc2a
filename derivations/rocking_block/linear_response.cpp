#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/linear_response.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::lst;

ex ground_acceleration(Pulse pulse) {
  const Letters& s = letters();
  const ex phase = s.omega_p * s.t + s.psi;
  if (pulse == Pulse::none) return 0;
  return pulse == Pulse::sine ? s.a_p * sin(phase) : s.a_p * cos(phase);
}

ex end_of_pulse(Pulse pulse) {
  const Letters& s = letters();
  // The cosine is the sine a quarter of a turn ahead, and ends with it.
  const ex last = pulse == Pulse::cosine ? 2 * GiNaC::Pi - GiNaC::Pi / 2 : 2 * GiNaC::Pi;
  return (last - s.psi) / s.omega_p;
}

LinearEquation linear_equation_under(Side side, const ex& ground) {
  const Letters& s = letters();
  const ex acceleration = angular_acceleration(side).subs(s.u_gddot == ground);
  const ex linear = taylor(acceleration, {s.alpha, s.theta, s.a_p}, 1);
  return {s.p, (linear - pow(s.p, 2) * s.theta).expand(), s.t};
}

LinearEquation linear_equation(Side side, Pulse pulse) {
  return linear_equation_under(side, ground_acceleration(pulse));
}

Given amplitude(Pulse pulse) {
  const Letters& s = letters();
  const ex at_rest = linear_equation(Side::negative, pulse).forcing.subs(s.t == 0);
  return {s.a_p, -at_rest.coeff(s.a_p, 0) / at_rest.coeff(s.a_p, 1)};
}

namespace {

Constants names(Side side) {
  const Letters& s = letters();
  return side == Side::negative ? Constants{s.A_1, s.A_2} : Constants{s.A_3, s.A_4};
}

Constants free_names(Side side) {
  const Letters& s = letters();
  return side == Side::negative ? Constants{s.Abar_1, s.Abar_2} : Constants{s.Abar_3, s.Abar_4};
}

ex with_amplitude(const ex& e, Pulse pulse) {
  const Given a = amplitude(pulse);
  return e.subs(a.name == a.value);
}

}  // namespace

ex forced_motion(Side side, Pulse pulse) {
  const Constants c = names(side);
  return general_solution(linear_equation(side, pulse), 0, c.C, c.D);
}

Constants forced_constants(Side side, Pulse pulse) {
  const Letters& s = letters();
  const Constants c = constants_from_start(linear_equation(side, pulse), 0, s.theta_0, s.thetadot_0);
  return {with_amplitude(c.C, pulse), with_amplitude(c.D, pulse)};
}

ex linear_response(Side side, Pulse pulse) {
  const Letters& s = letters();
  return solution_from(linear_equation(side, pulse), 0, s.theta_0, s.thetadot_0);
}

ex by_half_phases(const ex& response) {
  const Letters& s = letters();
  const ex circular = s.omega_p * s.t, real = s.p * s.t;
  const GiNaC::symbol sine("sine"), cosine("cosine"), hyperbolic_sine("sh"), hyperbolic_cosine("ch");
  const lst double_phases{sin(circular) == 2 * sine * cosine, cos(circular) == 1 - 2 * pow(sine, 2),
                          sinh(real) == 2 * hyperbolic_sine * hyperbolic_cosine,
                          cosh(real) == 1 + 2 * pow(hyperbolic_sine, 2)};
  const ex sum = sin(s.psi) * cos(circular) + cos(s.psi) * sin(circular);
  const lst functions{sine, cosine, hyperbolic_sine, hyperbolic_cosine};
  const ex collected =
      response.subs(sin(circular + s.psi) == sum).subs(double_phases).expand().collect(functions, true);
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
  return general_solution(linear_equation(side, Pulse::none), letters().t_o, c.C, c.D);
}

ex growing_part(const ex& free_motion, const ex& start) {
  const Letters& s = letters();
  const GiNaC::symbol growth("growth");
  const ex phase = s.p * (s.t - start);
  const ex in_growth = free_motion.subs(
      lst{sinh(phase) == (growth - 1 / ex(growth)) / 2, cosh(phase) == (growth + 1 / ex(growth)) / 2});
  return in_growth.expand().coeff(growth, 1);
}

namespace {

Derivation linearised(Side side, const Cited& exact, Pulse pulse) {
  const Letters& s = letters();
  const LinearEquation equation = linear_equation(side, pulse);
  Derivation result =
      derived(s.thetaddot - pow(equation.k, 2) * s.theta, equation.forcing,
              {from(exact, "Take"),
               {"with", s.u_gddot, ground_acceleration(pulse)},
               in_words("to first order in α, θ and α_p/g together: cos is 1, sin is its argument")});
  result.order = 1;
  result.small = "alpha, theta, a_p/g";
  return result;
}

Derivation forced(Side side, const Cited& equation) {
  const Letters& s = letters();
  const ex particular = particular_solution(linear_equation(side, Pulse::sine));
  return derived(
      s.theta, forced_motion(side, Pulse::sine),
      {from(equation, "Solve"),
       {"undetermined coefficients: a constant, sin(ω_p t + ψ) and cos(ω_p t + ψ) give the solution", s.theta,
        particular},
       in_words("and sinh p t, cosh p t solve the equation without its right side")});
}

Derivation forced_rate(Side side, const Cited& motion) {
  const Letters& s = letters();
  const ex rate = forced_motion(side, Pulse::sine).diff(s.t);
  return derived(s.thetadot / s.p, (with_amplitude(rate, Pulse::sine) / s.p).expand(),
                 {from(motion, "Differentiate"), from(linear_amplitude(), "and put in the amplitude")});
}

Derivation constant(Side side, bool first, const Cited& motion, const Cited& rate) {
  const Constants name = names(side), value = forced_constants(side, Pulse::sine);
  return derived(first ? name.C : name.D, first ? value.C : value.D,
                 {from(motion, "Set t = 0 in"), from(rate, "and in"), in_words("where θ = θ_0, θ̇ = θ̇_0")});
}

Derivation free_equation(Side side, const Cited& forced_equation) {
  const Letters& s = letters();
  return derived(s.thetaddot - pow(s.p, 2) * s.theta, linear_equation(side, Pulse::none).forcing,
                 {from(forced_equation, "Let the ground rest in")});
}

Derivation free(Side side, const Cited& equation) {
  return derived(letters().theta, free_motion(side),
                 {from(equation, "Solve #, counting time from t_o"), in_words("sinh, cosh and a constant")});
}

Derivation free_rate(Side side, const Cited& motion) {
  const Letters& s = letters();
  return derived(
      s.thetadot / s.p, (free_motion(side).diff(s.t) / s.p).expand(),
      {from(motion, "Differentiate"), in_words("the left side is the angular velocity at t, not at t_o")});
}

Derivation free_constant(Side side, bool first, const Cited& motion) {
  const Letters& s = letters();
  const Constants name = free_names(side);
  const Constants value =
      constants_from_start(linear_equation(side, Pulse::none), s.t_o, s.theta_to, s.thetadot_to);
  return derived(first ? name.C : name.D, first ? value.C : value.D,
                 {from(motion, "Set t = t_o in"), in_words("and in its derivative")});
}

// Where the free block of (21) can stand: its weight above the pivot.
Derivation critical_angle(Side side, const ex& value) {
  const Letters& s = letters();
  const ex weight = angular_acceleration(side).subs(s.u_gddot == 0);
  return derived(s.theta_star, value,
                 {{"After the pulse the block accelerates with", s.thetaddot, weight},
                  {"which vanishes, between lying down and standing, where the weight is above the pivot",
                   s.theta, value},
                  in_words("an equilibrium that a disturbance leaves: the critical motion ends there")});
}

}  // namespace

Derivation equation_53a() {
  const Letters& s = letters();
  return derived(s.u_gddot_0, ground_acceleration(Pulse::sine).subs(s.t == 0),
                 {in_words("Set t = 0 in (52)")});
}

Derivation equation_53b() {
  const Letters& s = letters();
  return derived(ground_acceleration(Pulse::sine).subs(s.t == 0), s.lambda * s.a_p,
                 {from(Cited{"53a", equation_53a}, "λ is the share of the amplitude at t = 0, and by #")});
}

Derivation equation_53c() {
  const Letters& s = letters();
  return derived(s.psi, asin(s.lambda),
                 {from(Cited{"53b", equation_53b}, "Solve # for ψ, between 0 and π/2")});
}

Derivation pulse_begins() {
  const Letters& s = letters();
  return derived(0, s.omega_p * s.t + s.psi, {in_words("One sine: the phase of (52) runs from 0")}, {}, "<=");
}

Derivation pulse_ends() {
  const Letters& s = letters();
  return derived(s.omega_p * s.t + s.psi, 2 * GiNaC::Pi, {in_words("One sine: the phase of (52) runs to 2π")},
                 {}, "<=");
}

Derivation equation_54() {
  const Letters& s = letters();
  const ex share = s.g * tan(s.alpha) / s.a_p;
  return derived(s.psi, asin(share), {from(Cited{"53c", equation_53c}, "Into"), {"put", s.lambda, share}});
}

Derivation equation_55a() {
  const Letters& s = letters();
  return derived(slope_of_diagonal(), s.b / s.h,
                 {from(Cited{"32b", equation_32b}, "The shape of the block")});
}

Derivation equation_55b() {
  const Letters& s = letters();
  return derived(s.b / s.h, s.mu, {in_words("Inequality (32), without its limit")}, {}, "<");
}

Derivation equation_56a() { return linearised(Side::negative, Cited{"21a", equation_21a}, Pulse::sine); }
Derivation equation_56b() { return linearised(Side::positive, Cited{"21b", equation_21b}, Pulse::sine); }

Derivation linear_amplitude() {
  const Letters& s = letters();
  Derivation result = derived(
      s.a_p / (s.g * s.alpha), amplitude(Pulse::sine).value / (s.g * s.alpha),
      {from(Cited{"56a", equation_56a}, "At rest and upright, about to move at t = 0, the right side of #"),
       in_words("vanishes; without linearisation tan α stands for α")});
  result.order = 1;
  result.small = "alpha";
  return result;
}

Derivation equation_57a() { return forced(Side::negative, Cited{"56a", equation_56a}); }
Derivation equation_57b() { return forced(Side::positive, Cited{"56b", equation_56b}); }
Derivation equation_59a() { return forced_rate(Side::negative, Cited{"57a", equation_57a}); }
Derivation equation_59b() { return forced_rate(Side::positive, Cited{"57b", equation_57b}); }
Derivation equation_58a() {
  return constant(Side::negative, true, Cited{"57a", equation_57a}, Cited{"59a", equation_59a});
}
Derivation equation_58b() {
  return constant(Side::negative, false, Cited{"57a", equation_57a}, Cited{"59a", equation_59a});
}
Derivation equation_58c() {
  return constant(Side::positive, true, Cited{"57b", equation_57b}, Cited{"59b", equation_59b});
}
Derivation equation_58d() {
  return constant(Side::positive, false, Cited{"57b", equation_57b}, Cited{"59b", equation_59b});
}
Derivation equation_60_negative() { return critical_angle(Side::negative, -letters().alpha); }
Derivation equation_60_positive() { return critical_angle(Side::positive, letters().alpha); }

Derivation equation_60_rate() {
  return derived(
      letters().thetadot_star, 0,
      {in_words("The critical motion neither falls over nor comes back: it ends in that equilibrium, "
                "which it approaches without end as t* grows")});
}

Derivation equation_61a() { return free_equation(Side::negative, Cited{"56a", equation_56a}); }
Derivation equation_61b() { return free_equation(Side::positive, Cited{"56b", equation_56b}); }
Derivation equation_62a() { return free(Side::negative, Cited{"61a", equation_61a}); }
Derivation equation_62b() { return free(Side::positive, Cited{"61b", equation_61b}); }
Derivation equation_63a() { return free_rate(Side::negative, Cited{"62a", equation_62a}); }
Derivation equation_63b() { return free_rate(Side::positive, Cited{"62b", equation_62b}); }
Derivation equation_64a() { return free_constant(Side::negative, true, Cited{"62a", equation_62a}); }
Derivation equation_64b() { return free_constant(Side::negative, false, Cited{"62a", equation_62a}); }
Derivation equation_64c() { return free_constant(Side::positive, true, Cited{"62b", equation_62b}); }
Derivation equation_64d() { return free_constant(Side::positive, false, Cited{"62b", equation_62b}); }

Derivation end_of_sine_pulse() {
  const Letters& s = letters();
  return derived(s.T_ex, end_of_pulse(Pulse::sine),
                 {in_words("The phase ω_p t + ψ of (52) has then come to 2π")});
}

}  // namespace rederive
