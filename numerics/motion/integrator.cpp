#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <numbers>
#include <numerics/motion/integrator.hpp>
#include <stdexcept>

namespace rederive::numerics {
namespace {

struct Motion {
  double alpha;
  int side;
  double value, slope;  // of the ground acceleration's line, at the start of the call
  double amplitude, omega, phase;
};

/// Equations (21a,b) for theta/alpha, with p = 1.
int right_hand_side(double t, const double state[], double rate[], void* parameters) {
  const Motion& motion = *static_cast<const Motion*>(parameters);
  double ground = motion.value + motion.slope * t;
  if (motion.amplitude != 0)
    ground += emitted::ground_of_sine_pulse(motion.amplitude, motion.omega, motion.phase, t);
  const double theta = motion.alpha * state[0];
  const double force = motion.alpha * ground;
  rate[0] = state[1];
  rate[1] = (motion.side < 0 ? emitted::angular_acceleration_negative(motion.alpha, 1.0, theta, force)
                             : emitted::angular_acceleration_positive(motion.alpha, 1.0, theta, force)) /
            motion.alpha;
  return GSL_SUCCESS;
}

Motion motion_from(const Block& block, const Piece& piece, int side, Real time) {
  const Real since = time - piece.from;
  return {block.alpha,
          side,
          static_cast<double>(piece.value + piece.slope * since),
          static_cast<double>(piece.slope),
          static_cast<double>(piece.amplitude),
          static_cast<double>(piece.omega),
          static_cast<double>(piece.omega * since + piece.phase)};
}

}  // namespace

RockingIntegrator::RockingIntegrator(const Block& block, double tolerance)
    : block_(block),
      step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2)),
      control_(gsl_odeiv2_control_y_new(tolerance, tolerance)),
      evolve_(gsl_odeiv2_evolve_alloc(2)) {
  gsl_set_error_handler_off();  // errors are told by status, not by abort
  if (!step_ || !control_ || !evolve_) throw std::bad_alloc();
}

/// By secants, one end held back where the other does not move (the Illinois rule).
Point RockingIntegrator::turning_point(const gsl_odeiv2_system& system, const Point& from, Real to,
                                       Real velocity) {
  double low = 0, high = static_cast<double>(to - from.time), at_low = static_cast<double>(from.velocity),
         at_high = static_cast<double>(velocity);
  const double start = static_cast<double>(from.time), enough = 1e-9 * high;
  double state[2] = {0, 0}, error[2], time = high;
  while (high - low > enough) {
    const double middle = low + (high - low) * at_low / (at_low - at_high);
    if (!(std::abs(middle - time) > enough * 1e-3)) break;
    time = middle;
    state[0] = static_cast<double>(from.angle), state[1] = static_cast<double>(from.velocity);
    gsl_odeiv2_step_reset(step_.get());
    gsl_odeiv2_step_apply(step_.get(), start, time, state, error, nullptr, nullptr, &system);
    if ((state[1] > 0) == (at_low > 0))
      low = time, at_low = state[1], at_high /= 2;
    else
      high = time, at_high = state[1], at_low /= 2;
  }
  return {from.time + time, state[0], state[1]};
}

Point RockingIntegrator::integrate(const Piece& piece, int side, const Point& from, Real time) {
  Motion motion = motion_from(block_, piece, side, from.time);
  gsl_odeiv2_system system{right_hand_side, nullptr, 2, &motion};
  gsl_odeiv2_evolve_reset(evolve_.get());
  gsl_odeiv2_step_reset(step_.get());
  const double lying = std::numbers::pi / 2 / block_.alpha;
  const double end = static_cast<double>(time - from.time);
  double t = 0, step = std::min(guess_, end);
  double state[2] = {static_cast<double>(from.angle), static_cast<double>(from.velocity)};
  for (int count = 0; t < end; ++count) {
    const double before = t, start[2] = {state[0], state[1]};
    const int status =
        gsl_odeiv2_evolve_apply(evolve_.get(), control_.get(), step_.get(), &system, &t, end, &step, state);
    if (status != GSL_SUCCESS || count > 1'000'000 || !std::isfinite(state[0]))
      throw std::runtime_error(
          fmt::format("the integration stopped at tau = {}", static_cast<double>(from.time) + t));
    if (t - before > guess_ / 4) guess_ = std::max(step, t - before);
    const bool turns = side * start[1] > 0 && side * state[1] < 0;
    const double farthest =
        std::max(side * start[0], side * state[0]) + (std::abs(start[1]) + std::abs(state[1])) * (t - before);
    if (turns && farthest >= lying) {
      const Point turn = turning_point(system, {before, start[0], start[1]}, t, state[1]);
      if (side * turn.angle >= lying) return {from.time + turn.time, turn.angle, 0};
    }
    if (side * state[0] >= lying) return {from.time + t, state[0], state[1]};
  }
  return {time, state[0], state[1]};
}

}  // namespace rederive::numerics
