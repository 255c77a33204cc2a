// Section 1: how the block starts, how it overturns, what friction must bear.
#include <fmt/format.h>

#include <cmath>
#include <emitted/rocking_block.hpp>
#include <lessons/rocking_block/claims_bench.hpp>
#include <limits>
#include <set>

namespace rederive::rocking_block {
using namespace language;
using namespace paper;
using namespace page;
using namespace ledger;

using namespace numerics;

namespace {

constexpr Block block;

/// Returns θ̈/p² at rest on a side, under a constant ground acceleration in units of g·tan α.
double first_acceleration(int side, double ground) {
  const double level = ground * std::tan(block.alpha);
  return side < 0 ? emitted::angular_acceleration_negative(block.alpha, 1.0, 0.0, level)
                  : emitted::angular_acceleration_positive(block.alpha, 1.0, 0.0, level);
}

Finding first_turn_large(Bench&, const Claim&) {
  const double negative = first_acceleration(-1, 1.5), positive = first_acceleration(1, 1.5);
  return {decided(negative < 0 && positive < 0), {negative, positive}};
}

Finding first_turn_moderate(Bench&, const Claim&) {
  double largest = -1e9, back = 1e9;
  for (int i = 1; i <= 400; ++i) {
    largest = std::max(largest, first_acceleration(1, i / 100.0));
    if (i <= 100) back = std::min(back, first_acceleration(-1, i / 100.0));
  }
  return {decided(largest > 0), {fixed(largest), fixed(back)}};
}

Finding free_rocking_period(Bench&, const Claim&) {
  double last = 0;
  bool grows = true;
  const std::string periods = each({0.1, 0.5, 0.9, 0.99}, [&](double share) {
    ResponseOptions options;
    options.until = 20, options.history = true;
    const Response motion = respond(paper_block(), Model::linear, {}, {share, 0}, options);
    const double period = 4 * first_time(motion, EventKind::impact);
    grows = grows && period > last, last = period;
    return fixed(period, 3);
  });
  return {decided(grows), {periods}};
}

Finding modes_of_overturning(Bench& bench, const Claim&) {
  std::string found;
  int most = 0;
  for (const double ratio : {0.5, 0.8, 1.0}) {
    std::set<int> impacts;
    for (const Window& window : bench.windows(pulse_case(ratio))) impacts.insert(impacts_of(window));
    const Window least = bench.least(pulse_case(ratio));
    most = std::max(most, *impacts.rbegin());
    add(found,
        fmt::format("ω_p/p = {:g}: after {} impacts, the least amplitude {:.4f} αg after {}", ratio,
                    fmt::join(impacts, ", "), least.from, impacts_of(least)),
        "; ");
  }
  return {decided(most <= 1), {found, most}};
}

Finding all_cases_covered(Bench& bench, const Claim&) {
  const auto& slow = bench.windows(pulse_case(0.5));
  const double cosine = bench.mode_1(cosine_case(2));
  int beyond = 0;
  for (const Window& window : slow) beyond += impacts_of(window) > 1;
  return {decided(beyond == 0 && cosine == 0), {beyond, static_cast<int>(slow.size()), cosine}};
}

Finding gap_below_mode_1(Bench& bench, const Claim&) {
  bool safe = false;
  const std::string found = each({1, 2, 3, 4}, [&](double ratio) {
    const PulseCase asked = pulse_case(ratio);
    const double upper = bench.mode_2_upper(asked), lower = bench.mode_1(asked);
    safe = safe || outcome_at(asked, (upper + lower) / 2).code == 0;
    return fmt::format("safe from {:.4f} to {:.4f}", upper, lower);
  });
  return {decided(!safe), {found, bench.say({"r12"})}};
}

Finding smaller_under_2b(Bench& bench, const Claim&) {
  std::string found;
  bool others = false;
  for (const Window& window : bench.windows(with_initial(cosine_case(2), 0.01, 0.2))) {
    others = others || impacts_of(window) > 0;
    add(found,
        fmt::format("{:.4f} to {} code {:+d}", window.from, window.to ? fixed(*window.to) : "…", window.code),
        "; ");
  }
  return {decided(!others), {found}};
}

Finding energy_under_ground_motion(Bench& bench, const Claim&) {
  const auto energy = [](double angle, double velocity) {
    return emitted::rocking_energy_negative(block.alpha, block.alpha * angle, block.alpha * velocity, 1.0);
  };
  const double amplitude = bench.mode_1(pulse_case(2)), corner = energy(-1, 0);
  double largest = -1e9, last = 0;
  for (const Sample& sample : samples_at(pulse_case(2), amplitude)) {
    last = energy(static_cast<double>(sample.angle), static_cast<double>(sample.velocity));
    largest = std::max(largest, last);
  }
  return {largest > last * 1.001 ? qualified : confirmed, {amplitude, largest / corner, last / corner}};
}

Finding least_start(Bench& bench, const Claim&) {
  ResponseOptions options;
  options.history = true;
  const Real level = start_level(paper_block(), Model::nonlinear);
  const auto moves = [&](Real share) {
    const GroundMotion ground{Piece{0, 1, share * level, 0, 0, 1, 0}};
    const auto events = respond(paper_block(), Model::nonlinear, ground, {}, options).events;
    return std::any_of(events.begin(), events.end(),
                       [](const Event& event) { return event.kind != EventKind::pulse_end; });
  };
  const bool below = moves(0.999L), above = moves(1.001L);
  return {decided(!below && above && bench.is_right("24b")),
          {bench.say({"24b"}), below ? "rocks" : "rests", above ? "rocks" : "rests"}};
}

/// Returns H/V by the corrected (47), for m = g = 1, on the side of the angle; infinity if V <= 0.
double friction(double theta, double thetadot, double ground) {
  const bool left = theta <= 0;
  const double h = left ? emitted::horizontal_reaction_negative(block.alpha, theta, thetadot, ground, 1.0)
                        : emitted::horizontal_reaction_positive(block.alpha, theta, thetadot, ground, 1.0);
  const double v = left ? emitted::vertical_reaction_negative(block.alpha, theta, thetadot, ground, 1.0)
                        : emitted::vertical_reaction_positive(block.alpha, theta, thetadot, ground, 1.0);
  return v > 0 ? h / v : std::numeric_limits<double>::infinity();
}

/// Returns the least and the largest H/V while the pulse lasts; infinity if V <= 0.
std::pair<double, double> friction_range(const PulseCase& asked, double amplitude) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Sample& sample : samples_at(asked, amplitude)) {
    if (sample.angle == 0) continue;
    const double ratio = friction(block.alpha * static_cast<double>(sample.angle),
                                  block.alpha * static_cast<double>(sample.velocity),
                                  block.alpha * static_cast<double>(sample.ground));
    least = std::min(least, ratio), most = std::max(most, ratio);
  }
  return {least, most};
}

Finding initiation_friction(Bench&, const Claim&) {
  const auto at_start = [](double ground) { return friction(0, 0, ground * std::tan(block.alpha)); };
  return {decided(std::abs(at_start(4) - at_start(1)) > 1e-6),
          {each({1, 1.5, 2, 4}, at_start), std::tan(block.alpha)}};
}

Finding sign_of_h(Bench& bench, const Claim&) {
  const auto [least, most] = friction_range(pulse_case(3, Model::nonlinear), 2);
  return {least >= 0 ? confirmed : qualified, {bench.say({"33"}), least, most}};
}

Finding tangent_is_enough(Bench&, const Claim&) {
  const auto [least, most] = friction_range(pulse_case(3, Model::nonlinear), 3);
  const double needed = std::max(-least, most);
  return {decided(needed <= std::tan(block.alpha)), {needed, std::tan(block.alpha)}};
}

}  // namespace

Checks checks_of_start() {
  return {{"first_turn_large", first_turn_large},
          {"first_turn_moderate", first_turn_moderate},
          {"free_rocking_period", free_rocking_period},
          {"modes_of_overturning", modes_of_overturning},
          {"all_cases_covered", all_cases_covered},
          {"gap_below_mode_1", gap_below_mode_1},
          {"smaller_under_2b", smaller_under_2b},
          {"energy_under_ground_motion", energy_under_ground_motion},
          {"least_start", least_start},
          {"initiation_friction", initiation_friction},
          {"sign_of_h", sign_of_h},
          {"tangent_is_enough", tangent_is_enough}};
}

}  // namespace rederive::rocking_block
