// Section 4 and conclusion 9: seconds, and the comparison with Eurocode 8.
#include <fmt/format.h>

#include <cmath>
#include <lessons/ledger/claims_checks.hpp>
#include <lessons/ledger/claims_readings.hpp>
#include <numbers>
#include <numerics/code_spectrum.hpp>

namespace rederive {

namespace {

constexpr double pi = std::numbers::pi;

/// The part T_ex = (2 pi - psi)/omega_p of a pulse in s, and the whole of it.
double rest_of_pulse(double ratio, double amplitude) {
  return (2 * pi - std::asin(1 / amplitude)) / (ratio * paper_block().p);
}
double whole_pulse(double ratio) { return 2 * pi / (ratio * paper_block().p); }

/// How a reading of T_ex takes pi, without the amplitude that goes into it; empty for others.
std::string convention(const Reading& reading) {
  const auto place = reading.says.find("2*pi = ");
  return place == std::string::npos ? "" : reading.says.substr(place);
}

/// The conventions under which both printed times come out, each with its printed amplitude.
std::string common_convention(Thresholds& bench) {
  std::string text;
  for (const Reading& one : fitting(compare_with("2.201", period_readings(bench, 1, 1))))
    for (const Reading& other : fitting(compare_with("0.672", period_readings(bench, 4, 2))))
      if (!convention(one).empty() && convention(one) == convention(other)) text = convention(one);
  return text;
}

Finding seconds(Workbench& bench, const Claim& claim, double ratio, double amplitude) {
  const auto matches = compare_with(claim.printed, period_readings(bench.thresholds(), ratio, amplitude));
  const double exact = rest_of_pulse(ratio, amplitude),
               least = rest_of_pulse(ratio, bench.thresholds().least(pulse_case(ratio)).from);
  const std::string found =
      fmt::format("(2π − ψ)/ω_p = {:.5f} s for {:g} αg, {:.5f} s for the least amplitude; {}", exact,
                  amplitude, least, summary(matches));
  const auto fits = fitting(matches);
  if (std::abs(exact - std::stod(claim.printed)) <= 0.0005) return confirmed(found, "As printed.");
  if (fits.empty()) return refuted(found, "No reading gives it.");
  const std::string both = common_convention(bench.thresholds());
  return refuted(found, "The last digit is wrong. " +
                            (both.empty() ? std::string("No one convention gives 2.201 and 0.672 both.")
                                          : "One convention gives 2.201 and 0.672 both: " + both + ".") +
                            " And the amplitude that goes into it is not a threshold.");
}

Finding seconds_at_1(Workbench& bench, const Claim& claim) { return seconds(bench, claim, 1, 1); }
Finding seconds_at_4(Workbench& bench, const Claim& claim) { return seconds(bench, claim, 4, 2); }

Finding called_period(Workbench&, const Claim&) {
  const double rest = rest_of_pulse(1, 1), whole = whole_pulse(1), rest_4 = rest_of_pulse(4, 2),
               whole_4 = whole_pulse(4);
  return decided(
      std::abs(rest - whole) < 1e-6,
      fmt::format("T_ex = {:.4f} s, 2π/ω_p = {:.4f} s at ω_p/p = 1; {:.4f} s and {:.4f} s at 4", rest, whole,
                  rest_4, whole_4),
      "They are the same.",
      fmt::format("T_ex runs from the start of rocking to the end of the pulse; the period is {:.0f} % and "
                  "{:.0f} % longer. With it the curves of Figs. 15 and 16 lie at the wrong periods.",
                  100 * (whole / rest - 1), 100 * (whole_4 / rest_4 - 1)));
}

Finding time_of_figure_15(Workbench& bench, const Claim&) {
  const double omega = 4 * paper_block().p,
               amplitude =
                   bench.thresholds().mode_1(pulse_case(4, Model::linear, {}, Pulse::cosine)).value_or(2);
  const double sine = rest_of_pulse(4, amplitude), cosine = (1.5 * pi - std::acos(1 / amplitude)) / omega;
  const std::string found = fmt::format(
      "ω_p/p = 4, {:.4f} αg: (2π − ψ)/ω_p = {:.4f} s for the sine, (3π/2 − ψ)/ω_p = {:.4f} s for the cosine "
      "pulse, both 2π/ω_p = {:.4f} s",
      amplitude, sine, cosine, whole_pulse(4));
  if (std::abs(sine - cosine) < 1e-3) return confirmed(found, "The same for both.");
  return qualified(found,
                   "For the sine pulse T_ex is that; for the cosine pulse it is another one. Pulses of one "
                   "frequency stand at two abscissas, neither of which is the period.");
}

struct Limit {
  double ground = 1e9, period = 0;
};

/// The largest a_g in g for which the lower curve of the one-sine pulse lies above the elastic spectrum.
Limit limit_of(Thresholds& bench, char ground, double damping) {
  Limit limit;
  for (int i = 8; i <= 80; i += 2) {
    const double ratio = i / 10.0;
    const auto after = bench.mode_2(pulse_case(ratio)), without = bench.mode_1(pulse_case(ratio));
    const double amplitude = after ? *after : without.value_or(20), period = rest_of_pulse(ratio, amplitude);
    const double allowed = 0.25 * amplitude / elastic_response(ground_type(ground), 1, damping, period);
    if (allowed < limit.ground) limit = {allowed, period};
  }
  return limit;
}

std::string zones_above(double limit) {
  std::string text;
  for (const double zone : {0.16, 0.24, 0.36})
    text += fmt::format("{}{:.2f} g {}", text.empty() ? "" : ", ", zone, zone <= limit ? "yes" : "no");
  return text;
}

Finding curve_above_spectrum(Workbench& bench, const Claim&) {
  const Limit five = limit_of(bench.thresholds(), 'A', 5), three = limit_of(bench.thresholds(), 'A', 3);
  const double both = std::min(five.ground, three.ground);
  const std::string found = fmt::format(
      "Type 1 spectrum, ground A: the lower curve lies above it for a_g up to {:.3f} g with ξ = 5 % and "
      "{:.3f} g with 3 %, touching at T = {:.2f} s; Greek zones {}",
      five.ground, three.ground, three.period, zones_above(both));
  if (both >= 0.36) return confirmed(found, "For all zones.");
  if (both < 0.16) return refuted(found, "For no zone.");
  return qualified(found,
                   "True up to that peak ground acceleration; the paper does not state the one it used, and "
                   "the abscissa is T_ex in place of a period.");
}

Finding both_soils(Workbench& bench, const Claim&) {
  const double a =
      std::min(limit_of(bench.thresholds(), 'A', 5).ground, limit_of(bench.thresholds(), 'A', 3).ground);
  const double b =
      std::min(limit_of(bench.thresholds(), 'B', 5).ground, limit_of(bench.thresholds(), 'B', 3).ground);
  const std::string found = fmt::format(
      "the comparison of Fig. 16 passes for a_g up to {:.3f} g on ground A and {:.3f} g on ground B; zones "
      "on B: {}",
      a, b, zones_above(b));
  if (b >= 0.36) return confirmed(found, "For both.");
  return decided(b >= a, found, "For both alike.",
                 fmt::format("Section 4 and the sentence before speak of ground A only, which makes sense "
                             "for a_g between {:.3f} g and {:.3f} g: there ground B fails the same test.",
                             b, a));
}

/// The test of the text: an amplitude above the ordinate of the elastic spectrum at "its period" is safe. A
/// pulse whose amplitude is the peak ground acceleration itself is the witness against it.
Finding safety_by_spectrum(Workbench& bench, const Claim&) {
  std::string found;
  bool witness = false;
  for (const auto& [ratio, amplitude] : {std::pair{1.0, 1.0}, std::pair{4.0, 2.0}}) {
    const double period = rest_of_pulse(ratio, amplitude),
                 ordinate = std::max(elastic_response(ground_type('A'), 1, 5, period),
                                     elastic_response(ground_type('A'), 1, 3, period));
    const double passes = 0.25 * amplitude / ordinate, pulse = 0.99 * passes / 0.25;
    const Window slow = bench.thresholds().least(pulse_case(0.5));
    const int code = pulse > 1 ? outcome_at(pulse_case(ratio), pulse).code : 0;
    witness = witness || code != 0;
    found += fmt::format(
        "{}({:g} αg, {:.3f} s) lies above S_e on A for both dampings while a_g < {:.3f} g; a pulse with "
        "ω_p/p = {:g} and amplitude {:.3f} g {}",
        found.empty() ? "" : "; ", amplitude, period, passes, ratio, 0.99 * passes,
        code == 0 ? std::string("does not overturn it") : fmt::format("overturns it (code {:+d})", code));
    if (pulse > slow.from && code == 0)
      found += fmt::format(", one with ω_p/p = 0.5 overturns from {:.3f} g on", 0.25 * slow.from),
          witness = true;
  }
  if (!witness) return undecided(found, "No counterexample was found among one-sine pulses.");
  return refuted(found,
                 "The test passes while a pulse no stronger than the peak ground acceleration overturns the "
                 "block. It compares an amplitude of the ground with the response of an oscillator, at a "
                 "time that is no period: it says nothing of safety.");
}

}  // namespace

Checks checks_of_spectra() {
  return {{"seconds_at_1", seconds_at_1},
          {"seconds_at_4", seconds_at_4},
          {"called_period", called_period},
          {"time_of_figure_15", time_of_figure_15},
          {"curve_above_spectrum", curve_above_spectrum},
          {"both_soils", both_soils},
          {"safety_by_spectrum", safety_by_spectrum}};
}

}  // namespace rederive
