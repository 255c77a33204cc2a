// The list of the steppers. Every rate comes from a derivation.
#include <derivations/emit/emit.hpp>
#include <derivations/emit/taylor.hpp>
#include <derivations/rocking_block/equation_of_motion.hpp>
#include <derivations/rocking_block/pulse.hpp>
#include <stdexcept>

namespace rederive {

namespace {

using GiNaC::ex;
using namespace paper;

/// A pulse is part of the state with its rate over ω_p: d²ü_g/dt² = c ü_g with c constant in time.
Rates pulse_rates(const SymbolExpression& ground, const SymbolExpression& quadrature) {
  const ex pulse = ground_acceleration(Pulse::sine);
  const ex c = (pulse.diff(t, 2) / pulse).normal();
  if (c.has(t)) throw std::logic_error("the pulse obeys no linear equation of its own");
  return {{ground, omega_p * quadrature}, {quadrature, c / omega_p * ground}};
}

TaylorStepper motion(Side side, bool in_pulse) {
  const SymbolExpression ground = emission_symbols()["ground"];
  const ex acceleration = angular_acceleration(side).subs(u_gddot == (in_pulse ? ex(ground * g) : ex(0)));
  const std::string on = side == Side::negative ? "negative" : "positive";
  TaylorStepper stepper{"free_motion_" + on,
                        {alpha, p},
                        {{theta, thetadot}, {thetadot, acceleration}},
                        side == Side::negative ? "21a" : "21b",
                        "Free rocking"};
  if (in_pulse) {
    stepper.name = "motion_in_pulse_" + on;
    stepper.brief = "Rocking under a one-sine or one-cosine pulse";
    stepper.parameters.push_back(omega_p);
    for (const auto& rate : pulse_rates(ground, emission_symbols()["quadrature"]))
      stepper.rates.push_back(rate);
  }
  stepper.brief += side == Side::negative ? ", theta < 0" : ", theta > 0";
  return stepper;
}

}  // namespace

std::vector<TaylorStepper> taylor_steppers() {
  std::vector<TaylorStepper> list;
  for (const bool in_pulse : {true, false})
    for (const Side side : {Side::negative, Side::positive}) list.push_back(motion(side, in_pulse));
  return list;
}

}  // namespace rederive
