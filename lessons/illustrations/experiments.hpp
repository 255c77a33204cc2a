// What the lessons compute with the numerics, in plain numbers. Times are p t, angles θ/α, velocities θ̇/(αp)
// and amplitudes a_p/(αg). The block has p = 2.14 1/s and the restitution of (46). The functions throw
// std::invalid_argument for ω_p/p or α (in rad) outside (0, π/2) and for amplitudes above 1e6.
#pragma once

#include <lessons/page/lesson.hpp>
#include <numerics/search/closed_form.hpp>
#include <numerics/search/windows.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rederive::illustrations {

/// A pulse that begins when rocking can start, and a block.
struct Experiment {
  double omega = 2, amplitude = 2, alpha = 0.25, until = 10;
  bool nonlinear = false, cosine = false;
  double theta_0 = 0, thetadot_0 = 0;      ///< rad, rad/s
  std::optional<double> restitution = {};  ///< if there is none, that of (46)
};

using Points = std::vector<std::pair<double, double>>;
struct Motion {
  Points angle, velocity, ground;  ///< against time
  Points phase;                    ///< velocity against angle
  int code = 0;                    ///< side·(impacts + 1), 0 if it is safe
  double needed_friction = 0;      ///< the largest |H|/V while it rocks
};
/// Returns the motion at `points` times.
Motion motion_of(const Experiment& experiment, int points = 400);
/// Returns the words for a code: "safe", "overturns to the left without impact".
std::string in_words(int code);

/// Returns the intervals of amplitudes that overturn, each in one way.
std::vector<numerics::Window> overturning_amplitudes(const Experiment& experiment, double largest = 12);
/// Returns the interval that begins first. Throws std::runtime_error if there is none up to `largest`.
numerics::Window least_overturning(const Experiment& experiment, double largest = 12);
/// Returns the smallest amplitude that overturns without impact, by simulation alone, to the last bit. For
/// the nonlinear model there is no other way.
double simulated_without_impact(const Experiment& experiment);
/// Returns the smallest admissible root of the paper's conditions, or nothing if there is none up to
/// `largest`.
std::optional<double> least_by_conditions(const Experiment& experiment, double largest = 12);

/// Returns the roots of the paper's conditions for overturning.
std::vector<numerics::ClosedForm> condition_roots(const Experiment& experiment);
/// Returns the numbers of the conditions: "(86) and (88)".
std::string conditions_of(const numerics::ClosedForm& root);
/// Returns "yes" if the block moves as the root says, or briefly why not.
std::string is_real(const numerics::ClosedForm& root);

/// Returns a_p/(αg) by (71).
double amplitude_without_impact(double omega);
/// Returns p T_ex of the sine pulse by (52): (2π − ψ)/(ω_p/p), with ψ from a_p sin ψ = αg.
double pulse_length(double omega, double amplitude);
}  // namespace rederive::illustrations
