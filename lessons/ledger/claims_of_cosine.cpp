// Section 3, Fig. 14 and conclusions 4 and 6 to 8: the cosine pulse, and initial conditions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lessons/ledger/claims_checks.hpp>
#include <lessons/ledger/claims_motion.hpp>
#include <lessons/ledger/claims_thresholds.hpp>

namespace rederive {

namespace {

constexpr double theta_0 = 0.01;

PulseCase cosine_case(double ratio) { return pulse_case(ratio, Model::linear, {}, Pulse::cosine); }

/// From which omega_p/p on (103) is the threshold of a motion that occurs, on a grid of 0.05; 0 if nowhere.
double first_admissible(double thetadot_0) {
  for (int i = 10; i <= 200; ++i) {
    const auto roots = roots_of(Form::eq103, with_initial(cosine_case(i / 20.0), theta_0, thetadot_0));
    if (!roots.empty() && roots.front().admissible) return i / 20.0;
  }
  return 0;
}

Finding admissible_103(Workbench&, const Claim&) {
  const double slow = first_admissible(0.1), fast = first_admissible(0.2);
  const ClosedForm at_1 = roots_of(Form::eq103, with_initial(cosine_case(1), theta_0, 0.2)).at(0);
  const ClosedForm at_4 = roots_of(Form::eq103, with_initial(cosine_case(4), theta_0, 0.1)).at(0);
  const std::string found = fmt::format(
      "θ_0 = 0.01, p = 2.14: a motion on θ > 0 up to T_ex from ω_p/p = {:.2f} on with θ̇_0 = 0.1 and {:.2f} "
      "with 0.2; at 1 with 0.2: {}; at 4 with 0.1: {:.4f} αg",
      slow, fast, at_1.why_not.empty() ? "admissible" : at_1.why_not, at_4.amplitude);
  if (slow == 0 && fast == 0) return refuted(found, "Nowhere: the block strikes before the pulse ends.");
  if (slow <= 0.5 && fast <= 0.5) return confirmed(found, "Everywhere.");
  return qualified(found,
                   "For fast pulses only. Under slow ones, ω_p/p = 1 among them, the positive part of the "
                   "pulse drives the block back through θ = 0 before it ends, and (103), "
                   "which needs θ > 0 up to T_ex, describes no motion.");
}

Finding cosine_from_rest(Workbench& bench, const Claim&) {
  const PulseCase asked = cosine_case(2);
  double first = -1;
  for (const Sample& sample : samples_at(asked, 2))
    if (first < 0 && sample.angle != 0) first = static_cast<double>(sample.time);
  return decided(first >= 0 && first < 0.02,
                 fmt::format("{}; ω_p/p = 2, 2 αg: still at rest until p·t = {:.3f}",
                             rows_say(bench, {"r13", "r14"}), first),
                 "It does.",
                 "At t = 0 the acceleration is just αg, and falls: the block stays. It starts at phase π − "
                 "ψ, where the ground accelerates the other way, and towards θ > 0.");
}

Finding threshold_cosine(Workbench& bench, const Claim& claim) {
  std::vector<std::pair<double, double>> simulated, printed;
  double nearest = 1e9;
  for (const double ratio : {0.5, 1.0, 2.0, 4.0, 6.0}) {
    simulated.emplace_back(ratio, bench.thresholds().mode_1(cosine_case(ratio)).value_or(0));
    printed.emplace_back(ratio, roots_of(Form::eq103, cosine_case(ratio)).at(0).amplitude);
    nearest = std::min(nearest, std::abs(simulated.back().second / printed.back().second - 1));
  }
  const std::string found = fmt::format(
      "cosine pulse from rest, least amplitude without impact, to θ > 0, by ω_p/p: simulated {}; (103) {}",
      paired(simulated), paired(printed));
  const bool overturns = simulated.front().second > 0;
  if (claim.check == "threshold_103")
    return decided(nearest < 1e-6, found, "They agree.",
                   "From rest the block starts later, at phase π − ψ; the threshold of that motion is row "
                   "r15, and (103) lies far above it.");
  return decided(!overturns, found, "It never does.",
                 "From rest, without impact and over O' it does, in the negative part of the cosine pulse "
                 "(row r15): it is exactly the motion of Fig. 2b.");
}

Finding push_in_104(Workbench&, const Claim&) {
  std::string found;
  bool lower = true;
  for (const double ratio : {1.0, 2.0, 4.0, 6.0}) {
    const double rest = roots_of(Form::eq71, pulse_case(ratio)).at(0).amplitude;
    const double pushed =
        roots_of(Form::eq104, with_initial(pulse_case(ratio), -theta_0, -0.1)).at(0).amplitude;
    lower = lower && pushed < rest;
    found += fmt::format("{}{:g}: {:.4f} < {:.4f}", found.empty() ? "" : ", ", ratio, pushed, rest);
  }
  return decided(lower, "(104) with θ_0 = −0.01, θ̇_0 = −0.1 against (71), by ω_p/p: " + found,
                 "The curve without impact is lower, as the text says of this curve.",
                 "It is not lower everywhere.");
}

/// Initial conditions of either sign, and what really overturns: all modes.
Finding push_and_minimum(Workbench& bench, const Claim&) {
  std::string found;
  int lower = 0, higher = 0;
  for (const double sign : {-1.0, 1.0})
    for (const double ratio : {2.0, 4.0}) {
      const double rest = bench.thresholds().least(pulse_case(ratio)).from;
      const Window pushed =
          bench.thresholds().least(with_initial(pulse_case(ratio), sign * theta_0, sign * 0.1));
      (pushed.from < rest ? lower : higher) += 1;
      found += fmt::format("{}{:+g} at {:g}: {:.4f} (code {:+d}) against {:.4f}", found.empty() ? "" : "; ",
                           sign * theta_0, ratio, pushed.from, pushed.code, rest);
    }
  const std::string whole =
      "least amplitude over all modes, θ_0 = ±0.01 with θ̇_0 = ±0.1, against rest: " + found;
  if (higher == 0) return confirmed(whole, "They lower it.");
  if (lower == 0) return refuted(whole, "They raise it.");
  return qualified(
      whole,
      "Negative ones lower the curve without impact, positive ones raise it. The least amplitude of all "
      "modes falls for slow pulses and rises for faster ones, whatever the sign.");
}

Finding caption_of_figure_14(Workbench&, const Claim&) {
  std::string found;
  int fine = 0, tried = 0;
  for (const double ratio : {1.0, 2.0, 4.0})
    for (const double sign : {0.0, 1.0, -1.0}) {
      const auto root =
          roots_of(Form::eq103, with_initial(cosine_case(ratio), sign * theta_0, sign * 0.1)).at(0);
      fine += root.admissible;
      ++tried;
      if (!root.admissible && ratio == 4)
        found += fmt::format("; with {:+g} at 4: {}", sign * theta_0, root.why_not);
    }
  const std::string whole =
      fmt::format("(103) for 0 and ±(0.01, 0.1) at ω_p/p = 1, 2, 4: {} of {} describe a motion that occurs{}",
                  fine, tried, found);
  if (fine == tried) return confirmed(whole, "All curves are thresholds.");
  if (fine == 0) return refuted(whole, "None is.");
  return qualified(
      whole,
      "Of the curves by (103) only that for positive conditions, and of it only the part for fast pulses, is "
      "a threshold of anything. The text speaks of θ̇_0 up to 0.2, the caption of 0.1.");
}

Finding more_unfavourable_103(Workbench&, const Claim&) {
  std::string found;
  int lower = 0, real = 0, tried = 0;
  for (const double ratio : {1.0, 2.0, 3.0, 4.0, 6.0}) {
    const ClosedForm cosine = roots_of(Form::eq103, with_initial(cosine_case(ratio), theta_0, 0.1)).at(0);
    const double sine = roots_of(Form::eq71, pulse_case(ratio)).at(0).amplitude;
    const double pushed =
        roots_of(Form::eq104, with_initial(pulse_case(ratio), -theta_0, -0.1)).at(0).amplitude;
    ++tried, lower += cosine.amplitude < std::min(sine, pushed),
        real += cosine.amplitude < std::min(sine, pushed) && cosine.admissible;
    found += fmt::format("{}{:g}: {:.4f}, {:.4f}, {:.4f}", found.empty() ? "" : "; ", ratio, cosine.amplitude,
                         sine, pushed);
  }
  const std::string whole = "(103) with +(0.01, 0.1), (71), (104) with −(0.01, 0.1) by ω_p/p: " + found;
  if (real == tried) return confirmed(whole, "It is the lowest.");
  if (real == 0) return refuted(whole, "It is not.");
  return qualified(
      whole,
      fmt::format("For fast pulses only ({} of {} here). Under slow ones, which the text calls the most "
                  "unfavourable, (103) is the higher one and describes no motion; from rest it is (78).",
                  real, tried));
}

Finding cosine_against_sine(Workbench& bench, const Claim&) {
  std::string found;
  int lower = 0, tried = 0;
  for (const double ratio : {0.5, 1.0, 2.0, 3.0, 4.0, 6.0}) {
    const double sine = bench.thresholds().least(pulse_case(ratio)).from,
                 cosine = bench.thresholds().least(cosine_case(ratio)).from;
    ++tried, lower += cosine < sine;
    found += fmt::format("{}{:g}: {:.4f} / {:.4f}", found.empty() ? "" : ", ", ratio, cosine, sine);
  }
  return decided(lower == tried,
                 "least amplitude from rest over all modes, cosine / sine, by ω_p/p: " + found, "It is.",
                 fmt::format("At {} of {} ratios the cosine pulse is the more harmless one, at all of the "
                             "paper's examples up to 4 among them; without impact alone it would be the "
                             "other way round, but the sine overturns after an impact first.",
                             tried - lower, tried));
}

}  // namespace

Checks checks_of_cosine() {
  return {{"admissible_103", admissible_103},
          {"cosine_from_rest", cosine_from_rest},
          {"threshold_103", threshold_cosine},
          {"cosine_overturns_from_rest", threshold_cosine},
          {"push_in_104", push_in_104},
          {"push_and_minimum", push_and_minimum},
          {"caption_of_figure_14", caption_of_figure_14},
          {"more_unfavourable_103", more_unfavourable_103},
          {"cosine_against_sine", cosine_against_sine}};
}

}  // namespace rederive
