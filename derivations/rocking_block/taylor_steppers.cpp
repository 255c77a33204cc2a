// The list of the steppers. Every rate comes from a derivation.
#include <derivations/rocking_block/arguments.hpp>
#include <derivations/rocking_block/emission.hpp>
#include <derivations/rocking_block/equation_of_motion.hpp>
#include <derivations/rocking_block/linear_response.hpp>
#include <derivations/rocking_block/pulse.hpp>
#include <stdexcept>

namespace rederive::rocking_block {

namespace {

using namespace arguments;

/// A pulse is part of the state with its rate over ω_p: d²ü_g/dt² = c ü_g with c constant in time.
Rates pulse_rates(const SymbolExpression& ground, const SymbolExpression& quadrature) {
  const ex pulse = ground_acceleration(Pulse::sine);
  const ex c = (pulse.diff(t, 2) / pulse).normal();
  if (c.has(t)) throw std::logic_error("the pulse obeys no linear equation of its own");
  return {{ground, omega_p * quadrature}, {quadrature, c / omega_p * ground}};
}

std::string name_of(Side side) { return side == Side::negative ? "negative" : "positive"; }
std::string range_of(Side side) { return side == Side::negative ? ", theta < 0" : ", theta > 0"; }

TaylorStepper free_motion(Side side) {
  const ex acceleration = angular_acceleration(side).subs(u_gddot == 0);
  return {"free_motion_" + name_of(side),
          {alpha, p},
          {{theta, thetadot}, {thetadot, acceleration}},
          side == Side::negative ? "21a" : "21b",
          "Free rocking" + range_of(side),
          t};
}

/// The acceleration under a ground acceleration that is part of the state, over g.
TaylorStepper in_pulse(TaylorStepper stepper, ex acceleration, const ex& ground_acceleration) {
  const SymbolExpression ground = numeric::ground;
  acceleration = GiNaC::collect_common_factors(acceleration.subs(ground_acceleration == ground * g).expand());
  stepper.parameters = {alpha, p, omega_p};
  stepper.rates = {{theta, thetadot}, {thetadot, acceleration}};
  for (const auto& rate : pulse_rates(ground, numeric::quadrature)) stepper.rates.push_back(rate);
  return stepper;
}

TaylorStepper motion_in_pulse(Side side) {
  return in_pulse({"motion_in_pulse_" + name_of(side),
                   {},
                   {},
                   side == Side::negative ? "21a" : "21b",
                   "Rocking under a one-sine or one-cosine pulse" + range_of(side),
                   t},
                  angular_acceleration(side), u_gddot);
}

TaylorStepper linear_motion_in_pulse(Side side) {
  const LinearEquation equation = linear_equation_under(side, a_p);
  return in_pulse({"linear_motion_in_pulse_" + name_of(side),
                   {},
                   {},
                   side == Side::negative ? "56a" : "56b",
                   "Linear rocking under a one-sine or one-cosine pulse" + range_of(side),
                   t},
                  pow(equation.k, 2) * theta + equation.forcing, a_p);
}

}  // namespace

std::vector<TaylorStepper> taylor_steppers() {
  std::vector<TaylorStepper> list;
  for (const auto make : {motion_in_pulse, free_motion, linear_motion_in_pulse})
    for (const Side side : {Side::negative, Side::positive}) list.push_back(make(side));
  return list;
}

}  // namespace rederive::rocking_block
