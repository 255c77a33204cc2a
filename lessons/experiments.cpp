#include <lessons/experiments.hpp>
#include <numerics/closed_form.hpp>
#include <numerics/ground_motion.hpp>
#include <numerics/story.hpp>
#include <numerics/windows.hpp>

#include <cmath>
#include <stdexcept>

namespace rederive {
namespace {

constexpr double frequency_parameter = 2.14;

PulseCase case_of(const Experiment& experiment) {
  PulseCase asked;
  asked.block = make_block(experiment.alpha, frequency_parameter);
  asked.model = experiment.nonlinear ? Model::nonlinear : Model::linear;
  asked.pulse = experiment.cosine ? Pulse::cosine : Pulse::sine;
  asked.omega_ratio = experiment.omega;
  asked.initial = initial_state(asked.block, asked.model, experiment.theta_0, experiment.thetadot_0);
  return asked;
}

PulseCase case_of(double omega, double alpha, bool nonlinear) {
  Experiment experiment;
  experiment.omega = omega;
  experiment.alpha = alpha;
  experiment.nonlinear = nonlinear;
  return case_of(experiment);
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (const auto& name : names) text += (text.empty() ? "(" : " and (") + name + ")";
  return text;
}

}  // namespace

Motion motion_of(const Experiment& experiment, int points) {
  const PulseCase asked = case_of(experiment);
  const GroundMotion ground = pulse_motion(asked.pulse, experiment.omega, experiment.amplitude,
                                           start_level(asked.block, asked.model));
  const Story story = tell(asked.block, asked.model, ground, asked.initial, experiment.until);
  Motion motion;
  motion.code = story.outcome.code;
  motion.needed_friction = required_friction(asked.block, asked.model, story).required;
  for (const auto& sample : sampled(asked.block, asked.model, ground, story.response, experiment.until, points)) {
    const double time = static_cast<double>(sample.time), angle = static_cast<double>(sample.angle);
    const double velocity = static_cast<double>(sample.velocity);
    if (std::abs(angle) > 3) break;  // it is falling: nothing more to see
    motion.angle.emplace_back(time, angle);
    motion.velocity.emplace_back(time, velocity);
    motion.phase.emplace_back(angle, velocity);
    motion.ground.emplace_back(time, static_cast<double>(sample.ground));
  }
  return motion;
}

std::string in_words(int code) {
  if (code == 0) return "safe";
  const int impacts = std::abs(code) - 1;
  const std::string times = impacts == 0 ? "without impact" : impacts == 1 ? "after one impact"
                                                            : "after " + std::to_string(impacts) + " impacts";
  return std::string("overturns to ") + (code < 0 ? "θ < 0 " : "θ > 0 ") + times;
}

std::vector<AmplitudeWindow> overturning_amplitudes(double omega, double alpha, bool nonlinear, double largest) {
  WindowSearch search;
  search.largest = largest;
  std::vector<AmplitudeWindow> result;
  for (const auto& window : overturning_windows(case_of(omega, alpha, nonlinear), search))
    result.push_back({window.from, window.to, window.code});
  return result;
}

LeastOverturning least_overturning(double omega, double alpha, bool nonlinear) {
  const auto windows = overturning_windows(case_of(omega, alpha, nonlinear), {});
  const auto least = least_window(windows);
  if (!least) throw std::runtime_error("no amplitude up to 12 overturns this block");
  return {least->from, least->code};
}

std::vector<ConditionRoot> condition_roots(const Experiment& experiment) {
  std::vector<ConditionRoot> result;
  for (const auto& root : closed_forms(case_of(experiment)))
    result.push_back({joined(root.equations()), root.amplitude, root.psi, root.impact_time, root.pulse_end,
                      root.admissible, root.why_not});
  return result;
}

double amplitude_without_impact(double omega) {
  Experiment experiment;
  experiment.omega = omega;
  for (const auto& root : condition_roots(experiment))
    if (root.equations == "(71)" && root.admissible) return root.amplitude;
  throw std::runtime_error("(71) has no admissible root here");
}

double pulse_length(double omega, double amplitude) {
  const GroundMotion motion = pulse_motion(Pulse::sine, omega, amplitude, 1);
  return static_cast<double>(motion.back().to);
}

double bisected_amplitude(double omega, double alpha, int code, double inside, double outside) {
  return edge_of_code(case_of(omega, alpha, false), code, inside, outside).inside;
}

}  // namespace rederive
