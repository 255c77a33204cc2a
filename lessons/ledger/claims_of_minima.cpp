// Section 4: which mode is least, where, and how much.
#include <fmt/format.h>

#include <cmath>
#include <lessons/ledger/claims_checks.hpp>
#include <lessons/ledger/claims_readings.hpp>

namespace rederive {

namespace {

Finding least_below_handover(Workbench& bench, const Claim&) {
  std::string found;
  bool always = true;
  for (const double ratio : {0.2, 0.5, 0.8, 1.0, 2.0, 3.0, 4.0}) {
    const Window least = bench.thresholds().least(pulse_case(ratio));
    always = always && least.code == 2;
    found += fmt::format("{}{:g}: {:.4f} after {}", found.empty() ? "" : ", ", ratio, least.from,
                         std::abs(least.code) - 1);
  }
  return decided(always, "least amplitude in αg by ω_p/p, after how many impacts: " + found,
                 "After one impact everywhere.",
                 "Not for slow pulses: there the least amplitude overturns after three or more impacts.");
}

Finding order_of_modes(Workbench& bench, const Claim&) {
  std::string found;
  bool holds_for_one = false;
  for (const std::optional<double> e : {std::optional<double>{}, std::optional<double>{0.9}}) {
    const PulseCase asked = pulse_case(1, Model::linear, e);
    const double from = bench.thresholds().handover_of(asked).value_or(0),
                 to = bench.thresholds().end_of(asked).value_or(0);
    holds_for_one = holds_for_one || (from <= 4.8 && to >= 6.7);
    found += fmt::format("{}e {}: from {:.4f} to {:.4f}", found.empty() ? "" : "; ", e ? "= 0.9" : "of (46)",
                         from, to);
  }
  const Window inside = bench.thresholds().least(pulse_case(5.5));
  found += fmt::format("; code {:+d} at 5.5", inside.code);
  if (inside.code != 2) return refuted(found, "Another mode is least there.");
  if (holds_for_one) return confirmed(found, "For the whole range.");
  return qualified(
      found,
      "The order of the modes is right, the limits are not: no single restitution gives both of them.");
}

Finding end_of_curve(Workbench& bench, const Claim& claim) {
  const auto matches = compare_with(claim.printed, end_readings(bench.thresholds()));
  const double own = bench.thresholds().end_of(pulse_case(1)).value_or(0),
               rounded = bench.thresholds().end_of(pulse_case(1, Model::linear, 0.9)).value_or(0);
  const std::string found =
      fmt::format("linear: {:.4f} with e of (46), {:.4f} with e = 0.9; {}", own, rounded, summary(matches));
  const auto fits = fitting(matches);
  if (fits.empty())
    return refuted(found,
                   "No convention with a name gives it; the value lies between those of e = 0.9 and of e of "
                   "(46), and seems read off the curve, which ends steeply.");
  return qualified(found, "By the reading above only.");
}

Finding beyond_the_end(Workbench& bench, const Claim&) {
  const auto after_impact = [&](double ratio, Model model) {
    return bench.thresholds().mode_2(pulse_case(ratio, model)).has_value();
  };
  const bool still = after_impact(6.8, Model::linear), full = after_impact(7.5, Model::nonlinear),
             gone = !after_impact(7, Model::linear) && !after_impact(10, Model::linear);
  const std::string found = fmt::format(
      "after one impact up to 20 αg with e of (46): at 6.8 {}, at 7 and 10 {}; nonlinear at 7.5 {}",
      still ? "yes" : "no", gone ? "no" : "yes", full ? "yes" : "no");
  if (!gone) return refuted(found, "It goes on.");
  if (!still && !full) return confirmed(found, "It does.");
  return qualified(
      found, fmt::format("From {:.2f} on in the linear model with e of (46); later in the nonlinear one.",
                         bench.thresholds().end_of(pulse_case(1)).value_or(0)));
}

Finding smallest_amplitude(Workbench& bench, const Claim&) {
  std::vector<std::pair<double, double>> least;
  for (const double ratio : {0.2, 0.5, 0.8, 1.0, 2.0, 4.0})
    least.emplace_back(ratio, bench.thresholds().least(pulse_case(ratio)).from);
  const bool lowest_at_1 = least[3].second < least[2].second && least[3].second < least[4].second;
  const bool is_one = std::abs(least[3].second - 1) < 0.005;
  return decided(
      lowest_at_1 && is_one, "least amplitude in αg by ω_p/p: " + paired(least), "It is.",
      "No minimum lies at ω_p/p = 1: the slower the pulse, the smaller the amplitude, and it tends to αg as "
      "ω_p/p → 0 without reaching it. αg is where rocking begins, not where the block overturns.");
}

Finding in_units_of_g(Workbench& bench, const Claim&) {
  const double here = 0.25 * bench.thresholds().least(pulse_case(1)).from, level = std::tan(0.25);
  return decided(
      std::abs(here - 0.25) < 0.005,
      fmt::format(
          "least amplitude at ω_p/p = 1: {:.4f} g; rocking of this block begins at g·tan α = {:.4f} g", here,
          level),
      "It is.", "0.25 g overturns nothing: it does not even set this block in motion.");
}

Finding phase_at_1(Workbench& bench, const Claim&) {
  const double root = roots_of(Form::eq86_88, pulse_case(1)).at(0).amplitude,
               least = bench.thresholds().least(pulse_case(1)).from;
  const int code = outcome_at(pulse_case(1), 1.0000001).code;
  return decided(std::abs(root - 1) < 0.005,
                 fmt::format("1/sin ψ at ω_p/p = 1: {:.4f} by (86), (88), {:.4f} for the least amplitude; "
                             "code at 1.0000001 αg: {}",
                             root, least, code),
                 "It is.",
                 "With sin ψ = 1 the pulse reaches αg at its crest only, and the block stays where it is.");
}

Finding amplitude_at_4(Workbench& bench, const Claim&) {
  std::vector<Reading> readings;
  for (const Reading& reading : threshold_readings(bench.thresholds(), 4, 1))
    if (reading.says.find("reciprocal") == std::string::npos &&
        reading.says.find("in g") != reading.says.size() - 4)
      readings.push_back(reading);
  const auto matches = compare_with("2.0", readings);
  const double own = bench.thresholds().mode_2(pulse_case(4)).value_or(0);
  const std::string found =
      fmt::format("linear, e of (46): {:.4f} αg = {:.4f} g; {}", own, own / 4, summary(matches));
  if (!fitting(matches).empty()) return qualified(found, "By the reading above only.");
  return refuted(
      found,
      fmt::format(
          "A round number: {:.0f} % above the least amplitude, on the unsafe side, and no reading gives 2.0.",
          100 * (2 / own - 1)));
}

}  // namespace

Checks checks_of_minima() {
  return {{"least_below_handover", least_below_handover},
          {"order_of_modes", order_of_modes},
          {"end_of_curve", end_of_curve},
          {"beyond_the_end", beyond_the_end},
          {"smallest_amplitude", smallest_amplitude},
          {"in_units_of_g", in_units_of_g},
          {"phase_at_1", phase_at_1},
          {"amplitude_at_4", amplitude_at_4}};
}

}  // namespace rederive
