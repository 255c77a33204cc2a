// What the lessons ask of the numerics, in plain numbers. Times are p t, angles θ/α, velocities θ̇/(αp), amplitudes
// a_p/(αg), as in DESIGN; the block has p = 2.14 1/s and the restitution of (46).
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rederive {

/// One motion under a one-sine pulse (or a one-cosine pulse) that begins when rocking can.
struct Experiment {
  double omega = 2, amplitude = 2, alpha = 0.25, until = 10;
  bool nonlinear = false, cosine = false;
  double theta_0 = 0, thetadot_0 = 0;  ///< rad, rad/s
};

struct Motion {
  std::vector<std::pair<double, double>> angle, velocity, phase, ground;  ///< against time; phase: (angle, velocity)
  int code = 0;                                                          ///< side·(impacts + 1), 0 = safe
  double needed_friction = 0;                                            ///< the largest |H|/V while it rocks
};
Motion motion_of(const Experiment& experiment, int points = 400);
/// "safe", "overturns to θ < 0 without impact" …
std::string in_words(int code);

/// An interval of amplitudes that overturn, all in the same way.
struct AmplitudeWindow {
  double from;
  std::optional<double> to;
  int code;
};
std::vector<AmplitudeWindow> overturning_amplitudes(double omega, double alpha, bool nonlinear, double largest = 12);

/// The smallest amplitude that overturns, and how.
struct LeastOverturning {
  double amplitude;
  int code;
};
LeastOverturning least_overturning(double omega, double alpha, bool nonlinear = false);

/// A root of one of the paper's conditions for overturning.
struct ConditionRoot {
  std::string equations;
  double amplitude, psi;
  std::optional<double> impact_time;
  double pulse_end;
  bool admissible;
  std::string why_not;
};
std::vector<ConditionRoot> condition_roots(const Experiment& experiment);

/// a_p/(αg) by (71).
double amplitude_without_impact(double omega);
/// p T_ex of the sine pulse by (52): (2π − ψ)/(ω_p/p), ψ from a_p sin ψ = αg.
double pulse_length(double omega, double amplitude);
/// The value to which an edge of overturning is bisected on the simulation itself, from below `guess`.
double bisected_amplitude(double omega, double alpha, int code, double inside, double outside);

}  // namespace rederive
