// The list of the steppers. Every rate comes from a derivation.
#include <array>
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

TaylorStepper without_ground(Side side) {
  const ex acceleration = angular_acceleration(side).subs(u_gddot == 0);
  return {"free_motion_" + name_of(side),
          {alpha, p},
          {{theta, thetadot}, {thetadot, acceleration}},
          side == Side::negative ? "21a" : "21b",
          "Free rocking" + range_of(side),
          t};
}

/// Motion under a ground acceleration that is part of the state, over g, beside what its rates need.
TaylorStepper with_ground(TaylorStepper stepper, ex acceleration, const ex& ground_acceleration,
                          const Rates& rates) {
  acceleration =
      GiNaC::collect_common_factors(acceleration.subs(ground_acceleration == numeric::ground * g).expand());
  stepper.rates = {{theta, thetadot}, {thetadot, acceleration}};
  stepper.rates.insert(stepper.rates.end(), rates.begin(), rates.end());
  return stepper;
}

/// The ground motions that have steppers: a pulse, and a straight line between two samples of a record.
enum class Ground { pulse, line };

std::string name_of(Ground ground) { return ground == Ground::pulse ? "in_pulse_" : "on_line_"; }
std::string brief_of(Ground ground) {
  return ground == Ground::pulse ? "under a one-sine or one-cosine pulse" : "under (ground + slope*t)*g";
}

Rates rates_of(Ground ground) {
  const SymbolExpression acceleration = numeric::ground;
  if (ground == Ground::pulse) return pulse_rates(acceleration, numeric::quadrature);
  return {{acceleration, numeric::slope}};
}

std::vector<SymbolExpression> parameters_of(Ground ground) {
  return {alpha, p, ground == Ground::pulse ? omega_p : numeric::slope};
}

TaylorStepper motion(Ground ground, Side side) {
  return with_ground({"motion_" + name_of(ground) + name_of(side),
                      parameters_of(ground),
                      {},
                      side == Side::negative ? "21a" : "21b",
                      "Rocking " + brief_of(ground) + range_of(side),
                      t},
                     angular_acceleration(side), u_gddot, rates_of(ground));
}

TaylorStepper linear_motion(Ground ground, Side side) {
  const LinearEquation equation = linear_equation_under(side, a_p);
  return with_ground({"linear_motion_" + name_of(ground) + name_of(side),
                      parameters_of(ground),
                      {},
                      side == Side::negative ? "56a" : "56b",
                      "Linear rocking " + brief_of(ground) + range_of(side),
                      t},
                     pow(equation.k, 2) * theta + equation.forcing, a_p, rates_of(ground));
}

}  // namespace

std::vector<TaylorStepper> taylor_steppers() {
  std::vector<TaylorStepper> list;
  const std::array sides{Side::negative, Side::positive};
  for (const Side side : sides) list.push_back(motion(Ground::pulse, side));
  for (const Side side : sides) list.push_back(without_ground(side));
  for (const Side side : sides) list.push_back(linear_motion(Ground::pulse, side));
  for (const Side side : sides) list.push_back(motion(Ground::line, side));
  for (const Side side : sides) list.push_back(linear_motion(Ground::line, side));
  return list;
}

}  // namespace rederive::rocking_block
