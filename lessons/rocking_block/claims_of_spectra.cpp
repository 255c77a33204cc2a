// Section 4 and conclusion 9: which mode is least, where, and how much; seconds, and Eurocode 8.
#include <fmt/format.h>

#include <cmath>
#include <lessons/rocking_block/claims_readings.hpp>
#include <numbers>
#include <numerics/records/code_spectrum.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace paper;
using namespace ledger;

using namespace numerics;

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
  std::erase_if(readings,
                [](const Reading& reading) { return reading.is_reciprocal || reading.unit == Unit::g; });
  const auto matches = compare_with("2.0", readings);
  const double own = bench.mode_2(pulse_case(4));
  return {fitting(matches).empty() ? refuted : qualified,
          {own, own / 4, summary(matches), 100 * (2 / own - 1)}};
}

using std::numbers::pi;

/// Return the part T_ex = (2 pi - psi)/omega_p of a pulse, and the whole pulse 2 pi/omega_p, in s.
double rest_of_pulse(double ratio, double amplitude) {
  return (2 * pi - std::asin(1 / amplitude)) / (ratio * paper_block().p);
}
double whole_pulse(double ratio) { return 2 * pi / (ratio * paper_block().p); }

/// Says whether there is one convention for pi under which both printed times come out, each with its printed
/// amplitude.
std::string common_convention(Bench& bench) {
  std::optional<ShortPi> common;
  for (const Reading& one : fitting(compare_with("2.201", period_readings(bench, 1, 1))))
    for (const Reading& other : fitting(compare_with("0.672", period_readings(bench, 4, 2))))
      if (one.pi && one.pi == other.pi) common = one.pi;
  return common ? "One convention gives 2.201 and 0.672 both: " + words_for(*common) + "."
                : "No one convention gives 2.201 and 0.672 both.";
}

Finding seconds(Bench& bench, const Claim& claim) {
  const double ratio = claim.omega_ratio, exact = rest_of_pulse(ratio, claim.amplitude),
               least = rest_of_pulse(ratio, bench.least(pulse_case(ratio)).from);
  const auto matches = compare_with(claim.printed, period_readings(bench, ratio, claim.amplitude));
  const std::string meaning = fitting(matches).empty()
                                  ? "No reading gives it."
                                  : "The last digit is wrong. " + common_convention(bench) +
                                        " And the amplitude that goes into it is not a threshold.";
  return {decided(std::abs(exact - std::stod(claim.printed)) <= 0.0005),
          {exact, claim.amplitude, least, summary(matches), meaning}};
}

Finding called_period(Bench&, const Claim&) {
  const double rest = rest_of_pulse(1, 1), whole = whole_pulse(1), rest_4 = rest_of_pulse(4, 2),
               whole_4 = whole_pulse(4);
  return {decided(std::abs(rest - whole) < 1e-6),
          {rest, whole, rest_4, whole_4, 100 * (whole / rest - 1), 100 * (whole_4 / rest_4 - 1)}};
}

Finding time_of_figure_15(Bench& bench, const Claim&) {
  const double omega = 4 * paper_block().p, amplitude = bench.mode_1(cosine_case(4));
  const double sine = rest_of_pulse(4, amplitude), cosine = (1.5 * pi - std::acos(1 / amplitude)) / omega;
  return {std::abs(sine - cosine) < 1e-3 ? confirmed : qualified, {amplitude, sine, cosine, whole_pulse(4)}};
}

struct Limit {
  double ground = 1e9, period = 0;
};

/// Returns the largest a_g, in g, for which the lower curve of the one-sine pulse lies above the elastic
/// spectrum.
Limit limit_of(Bench& bench, char ground, double damping) {
  Limit limit;
  for (int i = 8; i <= 80; i += 2) {
    const double ratio = i / 10.0, after = bench.mode_2(pulse_case(ratio));
    const double amplitude = after > 0 ? after : bench.mode_1(pulse_case(ratio)),
                 period = rest_of_pulse(ratio, amplitude);
    const double allowed = 0.25 * amplitude / elastic_response(ground_type(ground), 1, damping, period);
    if (allowed < limit.ground) limit = {allowed, period};
  }
  return limit;
}

std::string zones_above(double limit) {
  std::string text;
  for (const double zone : {0.16, 0.24, 0.36})
    add(text, fmt::format("{:.2f} g {}", zone, zone <= limit ? "yes" : "no"));
  return text;
}

ClaimVerdict for_zones(double limit) {
  return limit >= 0.36 ? confirmed : limit < 0.16 ? refuted : qualified;
}

Finding curve_above_spectrum(Bench& bench, const Claim&) {
  const Limit five = limit_of(bench, 'A', 5), three = limit_of(bench, 'A', 3);
  const double both = std::min(five.ground, three.ground);
  return {for_zones(both), {five.ground, three.ground, three.period, zones_above(both)}};
}

Finding both_soils(Bench& bench, const Claim&) {
  const auto limit = [&](char ground) {
    return std::min(limit_of(bench, ground, 5).ground, limit_of(bench, ground, 3).ground);
  };
  const double a = limit('A'), b = limit('B');
  return {decided(b >= 0.36 || b >= a), {a, b, zones_above(b)}};
}

/// Decides the test of the text, that an amplitude above the ordinate of the elastic spectrum at "its period"
/// is safe. A pulse whose amplitude is the peak ground acceleration is the witness against it.
Finding safety_by_spectrum(Bench& bench, const Claim&) {
  std::string found;
  bool witness = false;
  const double slow = bench.least(pulse_case(0.5)).from;
  for (const auto& [ratio, amplitude] : {std::pair{1.0, 1.0}, std::pair{4.0, 2.0}}) {
    const double period = rest_of_pulse(ratio, amplitude),
                 ordinate = std::max(elastic_response(ground_type('A'), 1, 5, period),
                                     elastic_response(ground_type('A'), 1, 3, period));
    const double passes = 0.25 * amplitude / ordinate, pulse = 0.99 * passes / 0.25;
    const int code = pulse > 1 ? outcome_at(pulse_case(ratio), pulse).code : 0;
    const bool slow_one = pulse > slow && code == 0;
    witness = witness || code != 0 || slow_one;
    const std::string outcome =
        code == 0 ? "does not overturn it" : fmt::format("overturns it (code {:+d})", code);
    add(found,
        fmt::format(
            "({:g} αg, {:.3f} s) lies above S_e on A for both dampings while a_g < {:.3f} g; a pulse with "
            "ω_p/p = {:g} and amplitude {:.3f} g {}",
            amplitude, period, passes, ratio, 0.99 * passes, outcome),
        "; ");
    if (slow_one) add(found, fmt::format("one with ω_p/p = 0.5 overturns from {:.3f} g on", 0.25 * slow));
  }
  return {witness ? refuted : undecided, {found}};
}

}  // namespace

Checks checks_of_spectra() {
  return {{"least_below_handover", least_below_handover},
          {"order_of_modes", order_of_modes},
          {"end_of_curve", end_of_curve},
          {"beyond_the_end", beyond_the_end},
          {"smallest_amplitude", smallest_amplitude},
          {"in_units_of_g", in_units_of_g},
          {"phase_at_1", phase_at_1},
          {"amplitude_at_4", amplitude_at_4},
          {"seconds", seconds},
          {"called_period", called_period},
          {"time_of_figure_15", time_of_figure_15},
          {"curve_above_spectrum", curve_above_spectrum},
          {"both_soils", both_soils},
          {"safety_by_spectrum", safety_by_spectrum}};
}

}  // namespace rederive::rocking_block
