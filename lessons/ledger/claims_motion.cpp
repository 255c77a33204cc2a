#include <algorithm>
#include <emitted/rocking_block.hpp>
#include <lessons/ledger/claims_motion.hpp>
#include <limits>

namespace rederive {

GroundMotion ground_of(const PulseCase& asked, double amplitude) {
  return pulse_motion(asked.pulse, asked.omega_ratio, amplitude, start_level(asked.block, asked.model));
}

std::vector<Sample> samples_at(const PulseCase& asked, double amplitude) {
  const GroundMotion ground = ground_of(asked, amplitude);
  ResponseOptions options;
  options.history = true;
  const Response motion = respond(asked.block, asked.model, ground, asked.initial, options);
  return sampled(asked.block, asked.model, ground, motion, ground.back().to, 400);
}

Response motion_under(const GroundMotion& ground) {
  ResponseOptions options;
  options.history = true;
  Response motion = respond(make_block(0.25, 2.14), Model::nonlinear, ground, {}, options);
  std::erase_if(motion.events, [](const Event& event) { return event.kind == EventKind::pulse_end; });
  return motion;
}

FrictionRange friction_range(const PulseCase& asked, double amplitude) {
  const double alpha = asked.block.alpha, one = 1;
  FrictionRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (const Sample& sample : samples_at(asked, amplitude)) {
    const double theta = alpha * static_cast<double>(sample.angle),
                 thetadot = alpha * static_cast<double>(sample.velocity);
    const double ground = alpha * static_cast<double>(sample.ground);
    if (theta == 0) continue;
    const bool left = theta < 0;
    const double h = left ? emitted::horizontal_reaction_negative(alpha, theta, thetadot, ground, one)
                          : emitted::horizontal_reaction_positive(alpha, theta, thetadot, ground, one);
    const double v = left ? emitted::vertical_reaction_negative(alpha, theta, thetadot, ground, one)
                          : emitted::vertical_reaction_positive(alpha, theta, thetadot, ground, one);
    const double ratio = v > 0 ? h / v : std::numeric_limits<double>::infinity();
    range = {std::min(range.least, ratio), std::max(range.most, ratio)};
  }
  return range;
}

}  // namespace rederive
