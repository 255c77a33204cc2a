#include <algorithm>
#include <cmath>
#include <lessons/illustrations/experiments.hpp>
#include <lessons/page/prose.hpp>
#include <numerics/motion/ground_motion.hpp>
#include <numerics/search/edges.hpp>
#include <numerics/search/story.hpp>
#include <stdexcept>

namespace rederive::illustrations {
using namespace decide;
using namespace paper;
using namespace page;
namespace {

constexpr double frequency_parameter = 2.14;

numerics::PulseCase case_of(const Experiment& experiment) {
  numerics::PulseCase asked;
  asked.block = numerics::make_block(experiment.alpha, frequency_parameter, experiment.restitution);
  asked.model = experiment.nonlinear ? numerics::Model::nonlinear : numerics::Model::linear;
  asked.pulse = experiment.cosine ? numerics::Pulse::cosine : numerics::Pulse::sine;
  asked.omega_ratio = experiment.omega;
  asked.initial = initial_state(asked.block, asked.model, experiment.theta_0, experiment.thetadot_0);
  return asked;
}

}  // namespace

Motion motion_of(const Experiment& experiment, int points) {
  const numerics::PulseCase asked = case_of(experiment);
  const numerics::GroundMotion ground = numerics::pulse_motion(
      asked.pulse, experiment.omega, experiment.amplitude, numerics::start_level(asked.block, asked.model));
  const numerics::Story story = tell(asked.block, asked.model, ground, asked.initial, experiment.until);
  Motion motion;
  motion.code = story.outcome.code;
  motion.needed_friction = required_friction(asked.block, story).required;
  for (const auto& sample : sampled(ground, story.response, experiment.until, points)) {
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

std::string in_words(int code) { return numerics::words_for(code, numerics::SideNames::directions); }

std::vector<numerics::Window> overturning_amplitudes(const Experiment& experiment, double largest) {
  numerics::WindowSearch search;
  search.largest = largest;
  return overturning_windows(case_of(experiment), search);
}

numerics::Window least_overturning(const Experiment& experiment, double largest) {
  const auto least = least_window(overturning_amplitudes(experiment, largest));
  if (!least) throw std::runtime_error("no amplitude up to the largest one overturns this block");
  return *least;
}

double simulated_without_impact(const Experiment& experiment) {
  const double near = amplitude_without_impact(experiment.omega);
  return numerics::edge_of_code(case_of(experiment), -1, 1.3 * near, std::max(1.02, 0.97 * near)).inside;
}

std::optional<double> least_by_conditions(const Experiment& experiment, double largest) {
  std::optional<double> least;
  for (const auto& root : condition_roots(experiment))
    if (root.admissible() && root.amplitude <= largest && (!least || root.amplitude < *least))
      least = root.amplitude;
  return least;
}

std::vector<numerics::ClosedForm> condition_roots(const Experiment& experiment) {
  return closed_forms(case_of(experiment));
}

std::string conditions_of(const numerics::ClosedForm& root) {
  return "(" + joined(equations_of(root.form), ") and (") + ")";
}

std::string is_real(const numerics::ClosedForm& root) {
  return root.admissible() ? "yes" : words_for(*root.why_not).brief;
}

double amplitude_without_impact(double omega) {
  Experiment experiment;
  experiment.omega = omega;
  for (const auto& root : condition_roots(experiment))
    if (root.form == numerics::Form::eq71 && root.admissible()) return root.amplitude;
  throw std::runtime_error("(71) has no admissible root here");
}

double pulse_length(double omega, double amplitude) {
  const numerics::GroundMotion motion = numerics::pulse_motion(numerics::Pulse::sine, omega, amplitude, 1);
  return static_cast<double>(motion.back().to);
}

}  // namespace rederive::illustrations
