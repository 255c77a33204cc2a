// The arguments of emitted functions: symbols that only numeric functions have, and expressions in these
// symbols with the scales that make them dimensionless.
#pragma once

#include <derivations/emit/emit.hpp>
#include <derivations/rocking_block/kinematics.hpp>
#include <derivations/rocking_block/pulse.hpp>
#include <stdexcept>

namespace rederive::rocking_block::arguments {

using GiNaC::ex;
using GiNaC::lst;

/// Symbols that only numeric functions have.
namespace numeric {
inline const language::Symbol ground{
    "ground", "\\gamma", "γ", "1", language::all_numbers, "acceleration of the ground over g", "emit"},
    amplitude{"amplitude", "a", "a", "1", "[0, inf)", "amplitude of the ground acceleration over g", "emit"},
    omega_ratio{"omega_ratio", "w", "w", "1", "(0, inf)", "omega_p/p", "emit"},
    tau_i{"tau_i", "\\tau_i", "τ_i", "1", "(0, inf)", "time of the impact, p*t_i", "emit"},
    share{"share", "\\lambda", "λ", "1", "(0, 1]", "acceleration of the ground at t = 0 over its amplitude",
          "emit"},
    angle{"angle", "\\theta/\\alpha", "θ/α", "1", language::all_numbers, "theta/alpha", "emit"},
    velocity{"velocity", "\\dot\\theta/(\\alpha p)", "θ̇/(αp)",
             "1",        language::all_numbers,      "thetadot/(alpha*p)",
             "emit"},
    slope{"slope", "\\dot\\gamma",        "γ̇",
          "1/s",   language::all_numbers, "rate of the ground acceleration over g",
          "emit"},
    quadrature{"quadrature", "\\gamma_\\perp",      "γ⊥",
               "1",          language::all_numbers, "rate of the ground acceleration over omega_p*g",
               "emit"},
    push{"push", "\\kappa", "κ", "1", language::all_numbers, "(theta_0 + thetadot_0/p)/alpha", "emit"};
}  // namespace numeric

/// Returns the name of the function for that side: "…_negative", "…_positive".
inline std::string on(Side side, const std::string& name) {
  return name + (side == Side::negative ? "_negative" : "_positive");
}
inline std::string sign(Side side) { return side == Side::negative ? "theta < 0" : "theta > 0"; }
inline std::string row(Side side, const std::string& negative, const std::string& positive) {
  return side == Side::negative ? negative : positive;
}

/// Returns the expression without a symbol that it contains but does not depend on. Throws std::logic_error
/// if it depends on the symbol.
inline ex without(const language::SymbolExpression& symbol, const ex& e) {
  if (!e.has(symbol)) return e;
  const bool independent = e.diff(symbol).normal().is_zero();
  if (!independent) throw std::logic_error("the expression must not depend on " + emit::name_of(symbol));
  return e.subs(symbol == 1);
}
inline ex with_ground(const ex& e) { return e.subs(u_gddot == numeric::ground * g); }
inline ex without_R(const ex& e) { return e.subs(R == 3 * g / (4 * pow(p, 2))); }
/// Returns the expression with ω_p = w p, t_i = τ_i/p and the end of the sine for T_ex; p and α drop out.
inline ex in_ratios(const ex& e) {
  const ex at_end = e.subs(T_ex == end_of_pulse(Pulse::sine));
  return without(
      alpha, without(p, at_end.subs(lst{omega_p == numeric::omega_ratio * p, t_i == numeric::tau_i / p})));
}
inline ex from_rest(const ex& e) { return in_ratios(e.subs(lst{theta_0 == 0, thetadot_0 == 0})); }
/// Returns the expression with the push in place of θ₀ and θ̇₀, which it contains in this combination alone.
inline ex with_push(const ex& e) {
  return in_ratios(without(thetadot_0, e.subs(theta_0 == alpha * numeric::push - thetadot_0 / p).expand()));
}

/// Writes the arguments of sines as products where they have common factors, so that they keep their digits
/// near 0.
struct FactoredSines : GiNaC::map_function {
  ex operator()(const ex& e) override {
    if (!GiNaC::is_the_function<GiNaC::sin_SERIAL>(e)) return e.map(*this);
    return sin(factor(e.op(0)));
  }
};
/// Returns the expression with θ = α angle and θ̇ = α p velocity; p drops out.
inline ex in_angle_and_velocity(const ex& e) {
  return without(p, e.subs(lst{theta == alpha * numeric::angle, thetadot == alpha * p * numeric::velocity}));
}
/// Returns a rate (power 1) over α p, or the square of a rate (power 2) over its square.
inline ex scaled_rate(const ex& rate, int power) {
  FactoredSines factored;
  return factored(in_angle_and_velocity((rate / pow(alpha * p, power)).expand()));
}
/// Returns the same of the linear model, from which α drops out as well.
inline ex scaled_linear_rate(const ex& rate, int power) {
  return without(alpha, in_angle_and_velocity(rate / pow(alpha * p, power)));
}

}  // namespace rederive::rocking_block::arguments
