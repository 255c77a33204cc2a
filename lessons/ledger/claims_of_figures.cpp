// Section 4: the printed amplitudes, the captions, and linear against nonlinear.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lessons/ledger/claims_checks.hpp>
#include <lessons/ledger/claims_readings.hpp>
#include <numerics/story.hpp>

namespace rederive {

namespace {

/// "a/b" or "a < b": the two numbers as printed.
std::pair<std::string, std::string> two_numbers(const std::string& printed) {
  const auto slash = printed.find('/');
  return {printed.substr(0, slash), printed.substr(slash + 1)};
}

std::string list_of(const std::vector<Reading>& readings) {
  std::string text;
  for (const Reading& reading : readings)
    text += fmt::format("{}{}: {:.6f}", text.empty() ? "" : "; ", reading.says, reading.value);
  return text.empty() ? "none" : text;
}

std::string outcome_says(int code) {
  return code == 0 ? "stays up" : fmt::format("overturns (code {:+d})", code);
}

/// A threshold that two printed numbers bracket: as labelled (linear, alpha*g), and read in every other way.
Finding bracket(Workbench& bench, const Claim& claim, double ratio, int impacts) {
  const auto [below, above] = two_numbers(claim.printed);
  const PulseCase asked = pulse_case(ratio);
  const int wanted = impacts == 0 ? -1 : 2;
  const auto code = [&](const std::string& amplitude) {
    return outcome_at(asked, std::stod(amplitude)).code;
  };
  const int code_below = code(below), code_above = code(above);
  const double labelled =
      (impacts == 0 ? bench.thresholds().mode_1(asked) : bench.thresholds().mode_2(asked)).value_or(0);
  const auto readings = threshold_readings(bench.thresholds(), ratio, impacts);
  const auto inside = between(below, above, readings);
  const auto matches = compare_with(below, readings);
  const auto fits = inside.empty() ? fitting(matches) : inside;
  const std::string between_them =
      inside.empty() ? fmt::format("none lies between the two numbers; {} {}", below, summary(matches))
                     : "between the two numbers lies " + list_of(inside);
  const std::string found = fmt::format(
      "as labelled the threshold is {:.6f} αg, and it {} at {} and {} at {}; of {} readings {}", labelled,
      outcome_says(code_below), below, outcome_says(code_above), above, readings.size(), between_them);
  if (code_below != wanted && code_above == wanted) return confirmed(found, "As labelled.");
  std::string meaning =
      code_below == wanted ? fmt::format("As labelled the block overturns at {} already.", below)
      : labelled > std::stod(above)
          ? fmt::format("As labelled neither overturns{}.",
                        std::stod(above) < 1 ? "; below 1 αg the block does not even move" : "")
          : "As labelled neither overturns.";
  if (!fits.empty())
    meaning +=
        fmt::format(" The numbers fit another reading ({}){}.", fits.front().says,
                    fits.front().says.starts_with("nonlinear")
                        ? ": the figure is not linearized, and its quantity is not the one in the caption"
                        : "");
  return refuted(found, meaning);
}

Finding number_at_2(Workbench& bench, const Claim& claim) { return bracket(bench, claim, 2, 0); }
Finding number_at_4(Workbench& bench, const Claim& claim) { return bracket(bench, claim, 4, 0); }
Finding number_at_3(Workbench& bench, const Claim& claim) { return bracket(bench, claim, 3, 1); }

/// Which model do the numbers of a figure belong to?
Finding linearized(Workbench& bench, const Claim& claim, double ratio, int impacts) {
  const auto [below, above] = two_numbers(claim.printed);
  const auto readings = threshold_readings(bench.thresholds(), ratio, impacts);
  auto fits = between(below, above, readings);
  for (const std::string& number : {below, above})
    for (const Reading& reading : fitting(compare_with(number, readings))) fits.push_back(reading);
  int linear = 0;
  for (const Reading& reading : fits) linear += reading.says.starts_with("linear");
  const std::string found = fmt::format("readings of {} that fit: {} linear, {} nonlinear", claim.printed,
                                        linear, fits.size() - static_cast<std::size_t>(linear));
  if (fits.empty()) return undecided(found, "No reading fits.");
  return decided(linear > 0, found, "A linear reading fits.",
                 "Only the nonlinear equations give these numbers; the caption says linearized solutions.");
}

Finding linearized_figure_8(Workbench& bench, const Claim& claim) { return linearized(bench, claim, 2, 0); }
Finding linearized_figure_9(Workbench& bench, const Claim& claim) { return linearized(bench, claim, 4, 0); }
Finding linearized_figure_12(Workbench& bench, const Claim& claim) { return linearized(bench, claim, 3, 1); }

Finding order_of_numbers(Workbench& bench, const Claim& claim) {
  const auto [below, above] = two_numbers(claim.printed);
  const PulseCase asked = pulse_case(3, Model::nonlinear, 0.9);
  const double threshold = bench.thresholds().mode_2(asked).value_or(0), level = std::tan(0.25) / 0.25;
  const auto code = [&](double share) { return outcome_at(asked, level / share).code; };
  const double far = 0.001;
  const int small = code(std::stod(below) - far), large = code(std::stod(above) + far);
  return decided(
      large == 2 && small == 0,
      fmt::format(
          "sin ψ at the threshold, nonlinear, e = 0.9: {:.7f}; the block {} at {} − 0.001, {} at {} + 0.001",
          level / threshold, outcome_says(small), below, outcome_says(large), above),
      "So it is.",
      "The number is sin ψ = g·tan α/a_p, which falls as the amplitude grows: the smaller number overturns, "
      "the larger does not.");
}

Finding restitution_behind_figures(Workbench& bench, const Claim&) {
  const auto threshold = fitting(compare_with("0.71156", threshold_readings(bench.thresholds(), 3, 1)));
  const auto handover = fitting(compare_with("4.8", handover_readings(bench.thresholds())));
  bool own = false;
  for (const auto& fits : {threshold, handover})
    for (const Reading& reading : fits) own = own || reading.says.find("(46)") != std::string::npos;
  const double derived = bench.thresholds().mode_2(pulse_case(3, Model::nonlinear)).value_or(0);
  return decided(own,
                 fmt::format("e of (46) is {:.5f}; 0.71156 fits {}; 4.8 fits {}; with e of (46) the "
                             "reciprocal of the nonlinear threshold is {:.5f}",
                             paper_block().restitution, list_of(threshold), list_of(handover),
                             1 / in_tangent(pulse_case(3), derived)),
                 "It is.",
                 "The numbers need the restitution of these readings, which the paper does not state; e of "
                 "(46) gives neither.");
}

Finding impact_in_figure(Workbench& bench, double ratio, bool during) {
  const PulseCase asked = pulse_case(ratio);
  const double amplitude = bench.thresholds().mode_2(asked).value_or(0);
  const Story story =
      tell(asked.block, asked.model, pulse_motion(asked.pulse, ratio, amplitude, 1), asked.initial);
  double impact = 0, end = 0;
  for (const Event& event : story.response.events) {
    if (event.kind == EventKind::impact && impact == 0) impact = static_cast<double>(event.time);
    if (event.kind == EventKind::pulse_end) end = static_cast<double>(event.time);
  }
  return decided(
      (impact < end) == during && impact > 0,
      fmt::format("ω_p/p = {:g}, {:.4f} αg: p·t_i = {:.4f}, p·T_ex = {:.4f}", ratio, amplitude, impact, end),
      "So it is.", "It is the other way round.");
}

Finding impact_in_figure_12(Workbench& bench, const Claim&) { return impact_in_figure(bench, 3, true); }
Finding impact_in_figure_13(Workbench& bench, const Claim&) { return impact_in_figure(bench, 5.5, false); }

Finding returns_to_rest(Workbench&, const Claim&) {
  const PulseCase asked = pulse_case(2, Model::nonlinear);
  const double amplitude = 2.35766 * std::tan(0.25) / 0.25;
  const Response motion =
      tell(asked.block, asked.model,
           pulse_motion(asked.pulse, 2, amplitude, start_level(asked.block, asked.model)), asked.initial, 200)
          .response;
  int impacts = 0;
  double rest = 0;
  for (const Event& event : motion.events) {
    impacts += event.kind == EventKind::impact;
    if (event.kind == EventKind::rest) rest = static_cast<double>(event.time);
  }
  return decided(
      rest > 0,
      fmt::format("nonlinear, 2.35766 g·tan α: after {} impacts at rest at p·t = {:.2f}", impacts, rest),
      "After a chain of ever smaller impacts.", "It does not come to rest.");
}

/// Relative differences between the models, nonlinear in alpha*g and in g*tan(alpha).
struct Differences {
  std::string text;
  double least = 1e9, most = -1e9;  ///< in alpha*g, in percent; positive: the linear block falls sooner
  double least_size = 1e9, most_size = 0;  ///< in either unit
};

Differences differences(Thresholds& bench, double alpha) {
  Differences all;
  for (const double ratio : {1.0, 2.0, 4.0, 5.5}) {
    const PulseCase linear = with_alpha(pulse_case(ratio), alpha),
                    full = with_alpha(pulse_case(ratio, Model::nonlinear), alpha);
    std::string pair;
    for (const bool impact : {false, true}) {
      const double a = (impact ? bench.mode_2(linear) : bench.mode_1(linear)).value_or(0),
                   b = (impact ? bench.mode_2(full) : bench.mode_1(full)).value_or(0);
      const double in_alpha = 100 * (b / a - 1), in_tan = 100 * (in_tangent(full, b) / a - 1);
      const double small = std::min(std::abs(in_alpha), std::abs(in_tan)),
                   large = std::max(std::abs(in_alpha), std::abs(in_tan));
      all.least = std::min(all.least, in_alpha), all.most = std::max(all.most, in_alpha);
      all.least_size = std::min(all.least_size, small), all.most_size = std::max(all.most_size, large);
      pair += fmt::format("{}{:+.1f} ({:+.1f}) % {}", pair.empty() ? "" : ", ", in_alpha, in_tan,
                          impact ? "after one impact" : "without");
    }
    all.text += fmt::format("{}{:g}: {}", all.text.empty() ? "" : "; ", ratio, pair);
  }
  return all;
}

Finding slender_blocks(Workbench& bench, const Claim&) {
  const Differences d = differences(bench.thresholds(), std::atan(0.25));
  const std::string found =
      "b/h = 0.25, nonlinear against linear thresholds in αg (in g·tan α) by ω_p/p: " + d.text;
  if (d.most_size < 1) return confirmed(found, "Within one percent.");
  if (d.least_size > 10) return refuted(found, "Nowhere within ten percent.");
  return qualified(
      found, fmt::format("Between {:+.1f} % and {:+.1f} % in αg here; where the difference is positive the "
                         "linear block falls sooner, which is the safe side, where negative it is not. "
                         "In which unit the amplitude is compared matters as much as the model.",
                         d.least, d.most));
}

Finding good_agreement(Workbench& bench, const Claim& claim) {
  const Differences d = differences(bench.thresholds(), 0.25);
  std::string found = "α = 0.25, nonlinear against linear thresholds in αg (in g·tan α) by ω_p/p: " + d.text;
  const auto linear = bench.thresholds().mode_2(pulse_case(7.5)),
             full = bench.thresholds().mode_2(pulse_case(7.5, Model::nonlinear));
  const double without = bench.thresholds().mode_1(pulse_case(7.5)).value_or(0);
  found +=
      fmt::format("; at 7.5 the linear block overturns {}, the nonlinear one {}",
                  linear ? fmt::format("after one impact from {:.2f} αg on", *linear)
                         : fmt::format("without impact only, from {:.2f} αg", without),
                  full ? fmt::format("after one impact from {:.2f} αg on", *full) : "without impact only");
  const bool parted = full.has_value() != linear.has_value();
  if (claim.check == "regions_of_agreement")
    return decided(d.least_size < 2 && (d.most_size > 4 || parted), found, "Both are there.",
                   "There is only one of the two.");
  if (d.most_size < 2 && !parted) return confirmed(found, "Everywhere.");
  if (d.least_size > 10) return refuted(found, "Nowhere.");
  return qualified(
      found,
      fmt::format("Within {:.0f} % here.{} Conclusion 3 speaks of disagreement itself.",
                  std::ceil(d.most_size),
                  parted ? " Beyond the end of the linear curve after one impact they part: the nonlinear "
                           "block still overturns so, far below what the linear curve allows."
                         : ""));
}

}  // namespace

Checks checks_of_figures() {
  return {{"number_at_2", number_at_2},
          {"number_at_4", number_at_4},
          {"number_at_3", number_at_3},
          {"linearized_figure_8", linearized_figure_8},
          {"linearized_figure_9", linearized_figure_9},
          {"linearized_figure_12", linearized_figure_12},
          {"order_of_numbers", order_of_numbers},
          {"restitution_behind_figures", restitution_behind_figures},
          {"impact_in_figure_12", impact_in_figure_12},
          {"impact_in_figure_13", impact_in_figure_13},
          {"returns_to_rest", returns_to_rest},
          {"slender_blocks", slender_blocks},
          {"good_agreement", good_agreement},
          {"regions_of_agreement", good_agreement}};
}

}  // namespace rederive
