// What the peers of the benchmarks have in common: the motion, its code, and what is left to each.
#pragma once

#include <array>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <numbers>
#include <numerics/motion/overturning.hpp>
#include <optional>

namespace rederive::benchmarks {

using State = std::array<double, 2>;  // theta, thetadot

/// Equations (21a,b) or (56) under a one-sine pulse, on one side, after some impacts; p = 1.
struct Motion {
  numerics::Model model;
  double alpha, restitution, amplitude, omega, psi;
  int side = -1, impacts = 0;

  void rates(double t, const double* y, double* rate) const {
    const double ground = emitted::ground_of_sine_pulse(amplitude, omega, psi, t);
    rate[0] = y[1];
    rate[1] = model == numerics::Model::linear ? y[0] - side * alpha - ground
              : side < 0 ? emitted::angular_acceleration_negative(alpha, 1.0, y[0], ground)
                         : emitted::angular_acceleration_positive(alpha, 1.0, y[0], ground);
  }
};

/// The code, where it is certain before the pulse is over, by the bounds of LanePack::foresee; nonlinear.
inline std::optional<int> early_code(const Motion& motion, double t, const State& y, double end) {
  const double x = motion.side * y[0] - motion.alpha, v = motion.side * y[1], left = end - t,
               g = motion.side * emitted::ground_of_sine_pulse(motion.amplitude, motion.omega, motion.psi, t),
               q = motion.side *
                   emitted::quadrature_of_sine_pulse(motion.amplitude, motion.omega, motion.psi, t),
               energy = v * v / 2 + std::cos(x), upright = 2 * (energy - std::cos(motion.alpha)),
               barrier = 2 * std::sin(motion.alpha / 2);
  const bool fades = motion.omega * left <= std::numbers::pi;
  const double most = !fades  ? motion.amplitude
                      : g < 0 ? 0
                      : q < 0 ? g
                              : motion.amplitude,
               sum = !fades ? motion.amplitude * left : (motion.amplitude + (g < 0 ? -q : q)) / motion.omega;
  if (v > 0 && (std::sin(x) > most * std::cos(x) || energy + most * std::sin(x) > std::sqrt(1 + most * most)))
    return motion.side * (motion.impacts + 1);
  if (x < 0 && sum < barrier && upright < (barrier - sum) * (barrier - sum)) return 0;
  if (x < 0 && v < 0 && fades && g >= 0 &&
      motion.restitution * motion.restitution * upright > barrier * barrier)
    return -motion.side * (motion.impacts + 2);
  return std::nullopt;
}

/// What a peer does on its own: follow the motion to `end`, or to where theta comes to 0 or the block lies;
/// or, if it decides early, to where it knows the code.
class Integrator {
 public:
  virtual ~Integrator() = default;
  virtual void follow(const Motion& motion, double& t, State& y, double end) = 0;
  bool decides_early = false;
};

/// The code of a one-sine pulse from rest.
inline int code_by(Integrator& integrator, const numerics::PulseCase& asked, double omega, double amplitude) {
  const double alpha = asked.block.alpha, restitution = asked.block.restitution;
  const bool linear = asked.model == numerics::Model::linear;
  const double level = linear ? alpha : emitted::ground_that_starts(alpha);
  if (alpha * amplitude <= level) return 0;
  Motion motion{asked.model,       alpha, restitution,
                alpha * amplitude, omega, emitted::phase_of_sine_pulse(level / (alpha * amplitude))};
  const double end = emitted::end_of_sine_pulse(omega, motion.psi);
  double t = 0;
  State y{0, 0};
  while (true) {
    integrator.follow(motion, t, y, end);
    if (!linear && motion.side * y[0] >= std::numbers::pi / 2) return motion.side * (motion.impacts + 1);
    if (t >= end) break;
    if (integrator.decides_early)
      if (const auto code = early_code(motion, t, y, end)) return *code;
    if (std::fabs(y[1]) < 1e-3 * alpha) return 0;
    y = {0, y[1] * restitution}, motion.side = -motion.side, ++motion.impacts;
  }
  return numerics::outcome_of_free_motion(asked.block, asked.model,
                                          numerics::FreeMotion<double>{.side = motion.side,
                                                                       .angle = motion.side * y[0] / alpha,
                                                                       .velocity = motion.side * y[1] / alpha,
                                                                       .impacts = motion.impacts})
      .code;
}

}  // namespace rederive::benchmarks
