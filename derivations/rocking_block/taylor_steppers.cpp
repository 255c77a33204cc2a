// The list of the Taylor steppers that are emitted. Every rate comes from a derivation.
#include <array>
#include <derivations/rocking_block/arguments.hpp>
#include <derivations/rocking_block/emission.hpp>
#include <derivations/rocking_block/equation_of_motion.hpp>
#include <derivations/rocking_block/linear_response.hpp>
#include <derivations/rocking_block/pulse.hpp>
#include <stdexcept>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace emit;

namespace {

using namespace arguments;

/// Returns the rates of a pulse, which is part of the state together with its rate over ω_p: d²ü_g/dt² = c
/// ü_g with a constant c.
Rates pulse_rates(const SymbolExpression& ground, const SymbolExpression& quadrature) {
  const ex pulse = ground_acceleration(Pulse::sine);
  const ex c = (pulse.diff(t, 2) / pulse).normal();
  if (c.has(t)) throw std::logic_error("the pulse obeys no linear equation of its own");
  return {{ground, omega_p * quadrature}, {quadrature, c / omega_p * ground}};
}

TaylorStepper without_ground(Side side) {
  const ex acceleration = angular_acceleration(side).subs(u_gddot == 0);
  return {.name = on(side, "free_motion"),
          .parameters = {alpha, p},
          .rates = {{theta, thetadot}, {thetadot, acceleration}},
          .equation = row(side, "21a", "21b"),
          .brief = "Free rocking, " + sign(side),
          .time = t};
}

/// The ground motions that have steppers: a pulse, and a straight line between two samples of a record.
enum class Ground { pulse, line };

Rates rates_of(Ground ground) {
  const SymbolExpression acceleration = numeric::ground;
  if (ground == Ground::pulse) return pulse_rates(acceleration, numeric::quadrature);
  return {{acceleration, numeric::slope}};
}

/// Returns the stepper of a motion under a ground acceleration that is part of the state, over g, beside what
/// its rates need.
TaylorStepper with_ground(Ground ground, Side side, bool is_linear, ex acceleration,
                          const ex& ground_acceleration, const std::string& equation) {
  const bool is_pulse = ground == Ground::pulse;
  acceleration =
      GiNaC::collect_common_factors(acceleration.subs(ground_acceleration == numeric::ground * g).expand());
  TaylorStepper stepper{
      .name = on(side,
                 (is_linear ? "linear_" : "") + std::string(is_pulse ? "motion_in_pulse" : "motion_on_line")),
      .parameters = {alpha, p, is_pulse ? omega_p : numeric::slope},
      .rates = {{theta, thetadot}, {thetadot, acceleration}},
      .equation = equation,
      .brief = (is_linear ? "Linear rocking " : "Rocking ") +
               std::string(is_pulse ? "under a one-sine or one-cosine pulse" : "under (ground + slope*t)*g") +
               ", " + sign(side),
      .time = t};
  for (const auto& rate : rates_of(ground)) stepper.rates.push_back(rate);
  return stepper;
}

TaylorStepper motion(Ground ground, Side side) {
  return with_ground(ground, side, false, angular_acceleration(side), u_gddot, row(side, "21a", "21b"));
}

TaylorStepper linear_motion(Ground ground, Side side) {
  const LinearEquation equation = linear_equation_under(side, a_p);
  return with_ground(ground, side, true, equation.forcing - equation.stiffness * theta, a_p,
                     row(side, "56a", "56b"));
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
