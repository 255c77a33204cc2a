// Section 4: the printed amplitudes, the captions, and linear against nonlinear.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lessons/rocking_block/claims_readings.hpp>
#include <numerics/search/story.hpp>

namespace rederive::rocking_block {
using namespace paper;
using namespace ledger;

using namespace numerics;

namespace {

/// Returns the two numbers of a text "a/b" as they are printed.
std::pair<std::string, std::string> two_numbers(const std::string& printed) {
  const auto slash = printed.find('/');
  return {printed.substr(0, slash), printed.substr(slash + 1)};
}

std::string list_of(const std::vector<Reading>& readings) {
  std::string text;
  for (const Reading& reading : readings)
    add(text, fmt::format("{}: {:.6f}", reading.says, reading.value), "; ");
  return text.empty() ? "none" : text;
}

std::string outcome_says(int code) {
  return code == 0 ? "stays up" : fmt::format("overturns (code {:+d})", code);
}

/// Decides whether two printed numbers bracket a threshold: as labelled (linear, alpha*g), and in all other
/// readings.
Finding bracket(Bench& bench, const Claim& claim) {
  const auto [below, above] = two_numbers(claim.printed);
  const PulseCase asked = pulse_case(claim.omega_ratio);
  const int wanted = claim.impacts == 0 ? -1 : 2;
  const auto code = [&](const std::string& amplitude) {
    return outcome_at(asked, std::stod(amplitude)).code;
  };
  const int code_below = code(below), code_above = code(above);
  const double labelled = bench.mode(claim.impacts, asked);
  const auto readings = threshold_readings(bench, claim.omega_ratio, claim.impacts);
  const auto inside = between(below, above, readings);
  const auto matches = compare_with(below, readings);
  const auto fits = inside.empty() ? fitting(matches) : inside;
  Items found{labelled,
              outcome_says(code_below),
              below,
              outcome_says(code_above),
              above,
              static_cast<int>(readings.size()),
              inside.empty()
                  ? fmt::format("none lies between the two numbers; {} {}", below, summary(matches))
                  : "between the two numbers lies " + list_of(inside)};
  if (code_below != wanted && code_above == wanted) return {confirmed, found};
  found.push_back(code_below == wanted ? fmt::format("the block overturns at {} already", below)
                  : labelled > std::stod(above) && std::stod(above) < 1
                      ? "neither overturns; below 1 αg the block does not even move"
                      : "neither overturns");
  const bool full = !fits.empty() && fits.front().model == Model::nonlinear;
  found.push_back(
      fits.empty()
          ? ""
          : fmt::format(" The numbers fit another reading ({}){}.", fits.front().says,
                        full
                            ? ": the figure is not linearized, and its quantity is not the one in the caption"
                            : ""));
  return {refuted, found};
}

/// Decides which model the numbers of a figure belong to.
Finding linearized(Bench& bench, const Claim& claim) {
  const auto [below, above] = two_numbers(claim.printed);
  const auto readings = threshold_readings(bench, claim.omega_ratio, claim.impacts);
  auto fits = between(below, above, readings);
  for (const std::string& number : {below, above})
    for (const Reading& reading : fitting(compare_with(number, readings))) fits.push_back(reading);
  int linear = 0;
  for (const Reading& reading : fits) linear += reading.model == Model::linear;
  return {fits.empty() ? undecided : decided(linear > 0),
          {claim.printed, linear, static_cast<int>(fits.size()) - linear}};
}

Finding order_of_numbers(Bench& bench, const Claim& claim) {
  const auto [below, above] = two_numbers(claim.printed);
  const PulseCase asked = pulse_case(3, Model::nonlinear, 0.9);
  const double level = std::tan(0.25) / 0.25, far = 0.001;
  const auto code = [&](double share) { return outcome_at(asked, level / share).code; };
  const int small = code(std::stod(below) - far), large = code(std::stod(above) + far);
  return {decided(large == 2 && small == 0),
          {level / bench.mode_2(asked), outcome_says(small), below, outcome_says(large), above}};
}

Finding restitution_behind_figures(Bench& bench, const Claim&) {
  const auto threshold = fitting(compare_with("0.71156", threshold_readings(bench, 3, 1)));
  const auto handover = fitting(compare_with("4.8", handover_readings(bench)));
  bool own = false;
  for (const auto& fits : {threshold, handover})
    for (const Reading& reading : fits) own = own || reading.has_own_restitution;
  const double derived = bench.mode_2(pulse_case(3, Model::nonlinear));
  return {decided(own),
          {paper_block().restitution, list_of(threshold), list_of(handover),
           1 / in_tangent(pulse_case(3), derived)}};
}

/// Decides whether the impact of the critical motion comes during the pulse or after it.
template <bool is_during_pulse>
Finding impact_in_figure(Bench& bench, const Claim& claim) {
  const PulseCase asked = pulse_case(claim.omega_ratio);
  const double amplitude = bench.mode_2(asked);
  const Response motion = tell(asked.block, asked.model, ground_of(asked, amplitude), asked.initial).response;
  const double impact = first_time(motion, EventKind::impact), end = first_time(motion, EventKind::pulse_end);
  return {decided((impact < end) == is_during_pulse && impact > 0),
          {claim.omega_ratio, amplitude, impact, end}};
}

Finding returns_to_rest(Bench&, const Claim&) {
  const PulseCase asked = pulse_case(2, Model::nonlinear);
  const GroundMotion ground = ground_of(asked, 2.35766 * std::tan(0.25) / 0.25);
  const Response motion = tell(asked.block, asked.model, ground, asked.initial, 200).response;
  int impacts = 0;
  for (const Event& event : motion.events) impacts += event.kind == EventKind::impact;
  const double rest = first_time(motion, EventKind::rest);
  return {decided(rest > 0), {impacts, rest}};
}

/// Relative differences between the models, with the nonlinear one in alpha*g and in g*tan(alpha).
struct Differences {
  std::string text;
  double least = 1e9, most = -1e9;  ///< in alpha*g, in percent; positive: the linear block falls sooner
  double least_size = 1e9, most_size = 0;  ///< in either unit
};

Differences differences(Bench& bench, double alpha) {
  Differences all;
  const auto say = [&](double ratio) {
    const PulseCase linear = with_alpha(pulse_case(ratio), alpha),
                    full = with_alpha(pulse_case(ratio, Model::nonlinear), alpha);
    std::string pair;
    for (const int impacts : {0, 1}) {
      const double a = bench.mode(impacts, linear), b = bench.mode(impacts, full);
      const double in_alpha = 100 * (b / a - 1), in_tan = 100 * (in_tangent(full, b) / a - 1);
      const auto [small, large] = std::minmax({std::abs(in_alpha), std::abs(in_tan)});
      all.least = std::min(all.least, in_alpha), all.most = std::max(all.most, in_alpha);
      all.least_size = std::min(all.least_size, small), all.most_size = std::max(all.most_size, large);
      add(pair, fmt::format("{:+.1f} ({:+.1f}) % {}", in_alpha, in_tan,
                            impacts == 1 ? "after one impact" : "without"));
    }
    return pair;
  };
  all.text = each({1, 2, 4, 5.5}, say, "; ");
  return all;
}

Finding slender_blocks(Bench& bench, const Claim&) {
  const Differences d = differences(bench, std::atan(0.25));
  return {d.most_size < 1 ? confirmed : d.least_size > 10 ? refuted : qualified, {d.text, d.least, d.most}};
}

/// Decides whether the models agree well, or, if `in_regions`, whether they agree in some regions and not in
/// others.
template <bool in_regions>
Finding good_agreement(Bench& bench, const Claim&) {
  const Differences d = differences(bench, 0.25);
  const double linear = bench.mode_2(pulse_case(7.5)), without = bench.mode_1(pulse_case(7.5)),
               full = bench.mode_2(pulse_case(7.5, Model::nonlinear));
  const auto from = [](double amplitude) {
    return fmt::format("after one impact from {:.2f} αg on", amplitude);
  };
  const bool parted = (full > 0) != (linear > 0);
  const Items found{d.text,
                    linear > 0 ? from(linear) : fmt::format("without impact only, from {:.2f} αg", without),
                    full > 0 ? from(full) : "without impact only", std::ceil(d.most_size),
                    parted ? " Beyond the end of the linear curve after one impact they part: the nonlinear "
                             "block still overturns so, far below what the linear curve allows."
                           : ""};
  if (in_regions) return {decided(d.least_size < 2 && (d.most_size > 4 || parted)), found};
  return {d.most_size < 2 && !parted ? confirmed : d.least_size > 10 ? refuted : qualified, found};
}

}  // namespace

Checks checks_of_figures() {
  return {{"bracket", bracket},
          {"linearized", linearized},
          {"order_of_numbers", order_of_numbers},
          {"restitution_behind_figures", restitution_behind_figures},
          {"impact_during_pulse", impact_in_figure<true>},
          {"impact_after_pulse", impact_in_figure<false>},
          {"returns_to_rest", returns_to_rest},
          {"slender_blocks", slender_blocks},
          {"good_agreement", good_agreement<false>},
          {"regions_of_agreement", good_agreement<true>}};
}

}  // namespace rederive::rocking_block
