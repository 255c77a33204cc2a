// Section 1: how the block starts, how it overturns, what friction must bear.
#include <fmt/format.h>

#include <cmath>
#include <emitted/rocking_block.hpp>
#include <lessons/ledger/claims_checks.hpp>
#include <lessons/ledger/claims_motion.hpp>
#include <lessons/ledger/claims_thresholds.hpp>
#include <numerics/story.hpp>
#include <set>

namespace rederive {

namespace {

constexpr double alpha = Block{}.alpha;

/// θ̈/p² just above rest on either side under a constant ground acceleration in units of g·tan α.
double first_acceleration(int side, double ground) {
  const double level = ground * std::tan(alpha);
  return side < 0 ? emitted::angular_acceleration_negative(alpha, 1.0, 0.0, level)
                  : emitted::angular_acceleration_positive(alpha, 1.0, 0.0, level);
}

Finding first_turn_large(Workbench&, const Claim&) {
  const double negative = first_acceleration(-1, 1.5), positive = first_acceleration(1, 1.5);
  return decided(
      negative < 0 && positive < 0,
      fmt::format("ü_g = 1.5 g·tan α: θ̈/p² = {:.4f} by (21a), {:.4f} by (21b) at θ = 0", negative, positive),
      "By either branch the block leaves rest towards θ < 0.", "It can leave rest towards θ > 0.");
}

Finding first_turn_moderate(Workbench&, const Claim&) {
  double largest = -1e9, back = 1e9;
  for (int i = 1; i <= 400; ++i) {
    largest = std::max(largest, first_acceleration(1, i / 100.0));
    if (i <= 100) back = std::min(back, first_acceleration(-1, i / 100.0));
  }
  return decided(
      largest > 0,
      fmt::format(
          "θ̈/p² by (21b) at θ = 0 for 0 < ü_g ≤ 4 g·tan α: at most {}; by (21a) up to g·tan α: at least {}",
          fixed(largest), fixed(back)),
      "It can.",
      "A positive acceleration presses the block towards θ < 0, however large; below g·tan α the block does "
      "not move at all.");
}

Finding free_rocking_period(Workbench&, const Claim&) {
  std::vector<std::pair<double, double>> periods;
  for (const double share : {0.1, 0.5, 0.9, 0.99}) {
    ResponseOptions options;
    options.until = 20, options.history = true;
    const Response motion = respond(paper_block(), Model::linear, {}, {share, 0}, options);
    for (const Event& event : motion.events)
      if (event.kind == EventKind::impact) {
        periods.emplace_back(share, 4 * static_cast<double>(event.time));
        break;
      }
  }
  bool grows = periods.size() == 4;
  for (std::size_t i = 1; i < periods.size(); ++i) grows = grows && periods[i].second > periods[i - 1].second;
  return decided(grows, "p × period of free rocking by θ_0/α: " + paired(periods, 3),
                 "It grows with the amplitude without bound.", "It does not depend on the amplitude.");
}

Finding modes_of_overturning(Workbench& bench, const Claim&) {
  std::string found;
  int most = 0;
  for (const double ratio : {0.5, 0.8, 1.0}) {
    std::set<int> impacts;
    for (const Window& window : bench.thresholds().windows(pulse_case(ratio)))
      impacts.insert(std::abs(window.code) - 1);
    const Window least = bench.thresholds().least(pulse_case(ratio));
    most = std::max(most, *impacts.rbegin());
    found += fmt::format("{}ω_p/p = {:g}: after {} impacts, the least amplitude {:.4f} αg after {}",
                         found.empty() ? "" : "; ", ratio, fmt::join(impacts, ", "), least.from,
                         std::abs(least.code) - 1);
  }
  return decided(most <= 1, found, "There are two modes.",
                 fmt::format("Slow pulses overturn the block after three and more impacts as well, here up "
                             "to {}, and at amplitudes below those of both modes of the paper.",
                             most));
}

Finding all_cases_covered(Workbench& bench, const Claim&) {
  const auto& slow = bench.thresholds().windows(pulse_case(0.5));
  const double cosine =
      bench.thresholds().mode_1(pulse_case(2, Model::linear, {}, Pulse::cosine)).value_or(0);
  std::size_t beyond = 0;
  for (const Window& window : slow) beyond += std::abs(window.code) > 2;
  return decided(beyond == 0 && cosine == 0,
                 fmt::format("ω_p/p = 0.5: {} of {} windows after more than one impact; the cosine pulse "
                             "from rest overturns to θ > 0 from {:.4f} αg at ω_p/p = 2",
                             beyond, slow.size(), cosine),
                 "All are covered.",
                 "Overturning after three and more impacts, the end of each window, and the cosine pulse "
                 "from rest are missing.");
}

Finding gap_below_mode_1(Workbench& bench, const Claim&) {
  std::string found;
  bool safe = false;
  for (const double ratio : {1.0, 2.0, 3.0, 4.0}) {
    const PulseCase asked = pulse_case(ratio);
    const double upper = bench.thresholds().mode_2_upper(asked).value_or(0),
                 lower = bench.thresholds().mode_1(asked).value_or(0);
    safe = safe || outcome_at(asked, (upper + lower) / 2).code == 0;
    found +=
        fmt::format("{}{:g}: safe from {:.4f} to {:.4f}", found.empty() ? "" : ", ", ratio, upper, lower);
  }
  return decided(!safe, "by ω_p/p, in αg: " + found + "; " + rows_say(bench, {"r12"}), "It does.",
                 "Just below the threshold without impact there is a range of safe amplitudes: the block "
                 "comes back with p·α, strikes, and e·p·α is too slow.");
}

Finding smaller_under_2b(Workbench& bench, const Claim&) {
  const PulseCase asked = with_initial(pulse_case(2, Model::linear, {}, Pulse::cosine), 0.01, 0.2);
  std::string found;
  bool others = false;
  for (const Window& window : bench.thresholds().windows(asked)) {
    others = others || std::abs(window.code) > 1;
    found += fmt::format("{}{:.4f} to {} code {:+d}", found.empty() ? "" : "; ", window.from,
                         window.to ? fixed(*window.to) : "…", window.code);
  }
  return decided(!others, "cosine pulse, ω_p/p = 2, θ_0 = 0.01, θ̇_0 = 0.2, overturns in αg: " + found,
                 "It does return.",
                 "It starts to θ > 0, comes back, strikes, and may overturn after that at amplitudes below "
                 "the one without impact.");
}

Finding energy_under_ground_motion(Workbench& bench, const Claim&) {
  const PulseCase asked = pulse_case(2);
  const double amplitude = bench.thresholds().mode_1(asked).value_or(0);
  double largest = -1e9, last = 0;
  for (const Sample& sample : samples_at(asked, amplitude)) {
    last = emitted::rocking_energy_negative(asked.block.alpha,
                                            asked.block.alpha * static_cast<double>(sample.angle),
                                            asked.block.alpha * static_cast<double>(sample.velocity), 1.0);
    largest = std::max(largest, last);
  }
  const double corner = emitted::rocking_energy_negative(asked.block.alpha, -asked.block.alpha, 0.0, 1.0);
  const std::string found = fmt::format(
      "ω_p/p = 2, {:.4f} αg, no impact: energy relative to the ground in units of that of the corner rises "
      "to {:.3f} and is {:.3f} when the pulse ends",
      amplitude, largest / corner, last / corner);
  if (!(largest > last * 1.001)) return confirmed(found, "Nothing else takes energy out.");
  return qualified(found,
                   "True while the ground rests. Under ground motion the ground does work of either sign: "
                   "its second half takes energy out of a block that neither slides nor strikes.");
}

Finding least_start(Workbench& bench, const Claim&) {
  const Real level = start_level(paper_block(), Model::nonlinear);
  const auto moves = [&](Real share) {
    return !motion_under({Piece{0, 1, share * level, 0, 0, 1, 0}}).events.empty();
  };
  const bool below = moves(0.999L), above = moves(1.001L);
  return decided(!below && above && rows_stand(bench, {"24b"}),
                 fmt::format("{}; simulated: 0.999 g·tan α {}, 1.001 g·tan α {}", rows_say(bench, {"24b"}),
                             below ? "rocks" : "rests", above ? "rocks" : "rests"),
                 "Below it the block rests, above it rocks.", "Rocking begins elsewhere.");
}

Finding initiation_friction(Workbench&, const Claim&) {
  std::vector<std::pair<double, double>> ratios;
  for (const double ground : {1.0, 1.5, 2.0, 4.0}) {
    const double level = ground * std::tan(alpha);
    ratios.emplace_back(ground, emitted::horizontal_reaction_negative(alpha, 0.0, 0.0, level, 1.0) /
                                    emitted::vertical_reaction_negative(alpha, 0.0, 0.0, level, 1.0));
  }
  return decided(
      std::abs(ratios.back().second - ratios.front().second) > 1e-6,
      fmt::format("H/V at the start by λ·a_p/(g·tan α): {}; tan α = {:.4f}", paired(ratios), std::tan(alpha)),
      "A pulse that begins at once with more than g·tan α needs more friction than tan α.",
      "It depends on the shape alone.");
}

Finding sign_of_h(Workbench& bench, const Claim&) {
  const auto [least, most] = friction_range(pulse_case(3, Model::nonlinear), 2);
  const std::string found =
      fmt::format("{}; H/V from {:.4f} to {:.4f} along the response at ω_p/p = 3, 2 αg, nonlinear",
                  rows_say(bench, {"33"}), least, most);
  if (least >= 0) return confirmed(found, "H does not change its sign.");
  return qualified(
      found,
      "The magnitude of H counts, since H/V is negative for a part of the motion; and V must be positive.");
}

Finding tangent_is_enough(Workbench&, const Claim&) {
  const PulseCase asked = pulse_case(3, Model::nonlinear);
  const auto [least, most] = friction_range(asked, 3);
  const double needed = std::max(-least, most);
  return decided(
      needed <= std::tan(alpha),
      fmt::format("largest |H|/V at ω_p/p = 3, 3 αg: {:.4f}; tan α = {:.4f}", needed, std::tan(alpha)),
      "It is enough.",
      "(55) covers the start only. Later in the motion friction must bear more, and with μ between the two "
      "the block slides.");
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

}  // namespace rederive
