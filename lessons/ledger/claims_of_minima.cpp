// Section 4: which mode is least, where, and how much.
#include <fmt/format.h>

#include <cmath>
#include <lessons/ledger/claims_readings.hpp>

namespace rederive {

namespace {

Finding least_below_handover(Bench& bench, const Claim&) {
  bool always = true;
  const std::string found = each({0.2, 0.5, 0.8, 1, 2, 3, 4}, [&](double ratio) {
    const Window least = bench.least(pulse_case(ratio));
    always = always && least.code == 2;
    return fmt::format("{:.4f} after {}", least.from, impacts_of(least));
  });
  return {decided(always), {found}};
}

Finding order_of_modes(Bench& bench, const Claim&) {
  std::string found;
  bool holds_for_one = false;
  for (const std::optional<double> e : {std::optional<double>{}, std::optional<double>{0.9}}) {
    const PulseCase asked = pulse_case(1, Model::linear, e);
    const double from = bench.handover_of(asked), to = bench.end_of(asked);
    holds_for_one = holds_for_one || (from <= 4.8 && to >= 6.7);
    add(found, fmt::format("e {}: from {:.4f} to {:.4f}", e ? "= 0.9" : "of (46)", from, to), "; ");
  }
  const int inside = bench.least(pulse_case(5.5)).code;
  return {inside != 2 ? refuted : holds_for_one ? confirmed : qualified, {found, inside}};
}

Finding end_of_curve(Bench& bench, const Claim& claim) {
  const auto matches = compare_with(claim.printed, end_readings(bench));
  const double own = bench.end_of(pulse_case(1)), rounded = bench.end_of(pulse_case(1, Model::linear, 0.9));
  return {fitting(matches).empty() ? refuted : qualified, {own, rounded, summary(matches)}};
}

Finding beyond_the_end(Bench& bench, const Claim&) {
  const auto after_impact = [&](double ratio, Model model) {
    return bench.mode_2(pulse_case(ratio, model)) > 0;
  };
  const bool still = after_impact(6.8, Model::linear), full = after_impact(7.5, Model::nonlinear),
             on = after_impact(7, Model::linear) || after_impact(10, Model::linear);
  const auto word = [](bool is) { return is ? "yes" : "no"; };
  return {on              ? refuted
          : still || full ? qualified
                          : confirmed,
          {word(still), word(on), word(full), bench.end_of(pulse_case(1))}};
}

Finding smallest_amplitude(Bench& bench, const Claim&) {
  const auto least = [&](double ratio) { return bench.least(pulse_case(ratio)).from; };
  return {decided(least(1) < std::min(least(0.8), least(2)) && std::abs(least(1) - 1) < 0.005),
          {each({0.2, 0.5, 0.8, 1, 2, 4}, least)}};
}

Finding in_units_of_g(Bench& bench, const Claim&) {
  const double here = 0.25 * bench.least(pulse_case(1)).from, level = std::tan(0.25);
  return {decided(std::abs(here - 0.25) < 0.005), {here, level}};
}

Finding phase_at_1(Bench& bench, const Claim&) {
  const double root = root_of(Form::eq86_88, pulse_case(1)).amplitude;
  const int code = outcome_at(pulse_case(1), 1.0000001).code;
  return {decided(std::abs(root - 1) < 0.005), {root, bench.least(pulse_case(1)).from, code}};
}

Finding amplitude_at_4(Bench& bench, const Claim&) {
  auto readings = threshold_readings(bench, 4, 1);
  std::erase_if(readings, [](const Reading& reading) {
    return reading.says.find("reciprocal") != std::string::npos || reading.says.ends_with("in g");
  });
  const auto matches = compare_with("2.0", readings);
  const double own = bench.mode_2(pulse_case(4));
  return {fitting(matches).empty() ? refuted : qualified,
          {own, own / 4, summary(matches), 100 * (2 / own - 1)}};
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
