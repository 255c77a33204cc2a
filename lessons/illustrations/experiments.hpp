// What the lessons ask of the numerics, in plain numbers. Times are p t, angles θ/α, velocities θ̇/(αp),
// amplitudes a_p/(αg), as in DESIGN; the block has p = 2.14 1/s and the restitution of (46). Ranges are those
// of the numerics (0 < ω_p/p, 0 < α < π/2 rad, amplitudes up to 1e6): what lies outside throws
// std::invalid_argument.
#pragma once

#include <lessons/page/lesson.hpp>
#include <numerics/search/closed_form.hpp>
#include <numerics/search/windows.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rederive {

/// One motion under a one-sine pulse (or a one-cosine pulse) that begins when rocking can.
struct Experiment {
  double omega = 2, amplitude = 2, alpha = 0.25, until = 10;
  bool nonlinear = false, cosine = false;
  double theta_0 = 0, thetadot_0 = 0;      ///< rad, rad/s
  std::optional<double> restitution = {};  ///< that of (46) if nothing is given
};

struct Motion {
  std::vector<std::pair<double, double>> angle, velocity, phase,
      ground;                  ///< against time; phase: (angle, velocity)
  int code = 0;                ///< side·(impacts + 1), 0 = safe
  double needed_friction = 0;  ///< the largest |H|/V while it rocks
};
Motion motion_of(const Experiment& experiment, int points = 400);
/// "safe", "overturns to the left without impact" …
std::string in_words(int code);

/// The intervals of amplitudes that overturn, each in one way, and the one that begins first:
/// std::runtime_error if there is none up to `largest`.
std::vector<numerics::Window> overturning_amplitudes(const Experiment& experiment, double largest = 12);
numerics::Window least_overturning(const Experiment& experiment, double largest = 12);
/// The smallest amplitude that overturns without impact, by simulation alone: bisected until two neighbouring
/// numbers of the machine are left. The one way to know it for the nonlinear model.
double simulated_without_impact(const Experiment& experiment);
/// The smallest admissible root of the paper's conditions; nothing if there is none up to `largest`.
std::optional<double> least_by_conditions(const Experiment& experiment, double largest = 12);

/// The roots of the paper's conditions for overturning; which conditions, "(86) and (88)", and whether the
/// block moves so: "yes", or why not in short; `rocking threshold` says more.
std::vector<numerics::ClosedForm> condition_roots(const Experiment& experiment);
std::string conditions_of(const numerics::ClosedForm& root);
std::string is_real(const numerics::ClosedForm& root);

/// a_p/(αg) by (71).
double amplitude_without_impact(double omega);
/// p T_ex of the sine pulse by (52): (2π − ψ)/(ω_p/p), ψ from a_p sin ψ = αg.
double pulse_length(double omega, double amplitude);
}  // namespace rederive
