// Section 3: overturning after one impact in the linear model.
#include <fmt/format.h>

#include <cmath>
#include <lessons/ledger/claims_checks.hpp>
#include <lessons/ledger/claims_readings.hpp>

namespace rederive {

namespace {

Finding admissible_86_88(Workbench&, const Claim& claim) {
  const std::optional<double> e = 0.9;
  std::string found;
  int fine = 0, tried = 0;
  for (const double ratio : {0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 4.75}) {
    for (const ClosedForm& root : roots_of(Form::eq86_88, pulse_case(ratio, Model::linear, e)))
      if (root.admissible) {
        ++fine;
        found += fmt::format("{}{:g}: {:.4f}", found.empty() ? "" : ", ", ratio, root.amplitude);
        break;
      }
    ++tried;
  }
  return decided(
      fine == tried,
      fmt::format("admissible roots by ω_p/p with e = 0.9, in αg: {} ({} of {})", found, fine, tried),
      "Each is where overturning after one impact begins; for slow pulses that is not the least amplitude, "
      "see the other claims.",
      "Not everywhere below " + claim.printed + ".");
}

Finding handover(Workbench& bench, const Claim& claim) {
  const auto matches = compare_with(claim.printed, handover_readings(bench.thresholds()));
  const double derived = bench.thresholds().handover_of(pulse_case(1)).value_or(0);
  const std::string found = fmt::format("linear, e of (46): {:.4f}; {}", derived, summary(matches));
  const auto fits = fitting(matches);
  if (fits.empty()) return refuted(found, "No reading gives it.");
  for (const Reading& reading : fits)
    if (std::abs(reading.value - derived) < 1e-12)
      return confirmed(found, "With the restitution that the paper derives.");
  return qualified(found,
                   "It depends on e. With e of (46) for α = 0.25 the impact passes the end of the pulse "
                   "later; the printed number is that of the reading above, which the paper does not state.");
}

Finding beyond_handover(Workbench&, const Claim&) {
  std::string found;
  bool all_late = true;
  for (const double ratio : {5.0, 5.5, 6.0, 8.0})
    for (const ClosedForm& root : roots_of(Form::eq86_88, pulse_case(ratio))) {
      all_late = all_late && !root.admissible && *root.impact_time > root.pulse_end;
      found += fmt::format("{}{:g}: {:.4f} > {:.4f}", found.empty() ? "" : ", ", ratio, *root.impact_time,
                           root.pulse_end);
    }
  return decided(all_late && !found.empty(), "p·t_i against p·T_ex by ω_p/p: " + found,
                 "Such roots contradict their own assumption.", "Some are admissible.");
}

Finding two_roots_of_96(Workbench& bench, const Claim&) {
  const PulseCase asked = pulse_case(5.5);
  std::string found;
  int minima = 0, others = 0;
  for (const ClosedForm& root : roots_of(Form::eq92a_96, asked)) {
    (root.admissible ? minima : others) += 1;
    found += fmt::format("{}{:.4f} αg{}", found.empty() ? "" : "; ", root.amplitude,
                         root.admissible ? "" : " (" + root.why_not + ")");
  }
  found += fmt::format("; simulated window {:.4f} to {:.4f}", bench.thresholds().mode_2(asked).value_or(0),
                       bench.thresholds().mode_2_upper(asked).value_or(0));
  if (minima == 1 && others == 0)
    return confirmed("ω_p/p = 5.5: " + found, "There is one solution, the minimum.");
  if (minima == 0) return refuted("ω_p/p = 5.5: " + found, "No solution is a minimum.");
  return qualified("ω_p/p = 5.5: " + found,
                   "One of the solutions is the minimum. Another is the largest amplitude that overturns "
                   "after one impact, of which the paper does not speak, and some belong to no motion.");
}

Finding independent_of_alpha(Workbench& bench, const Claim&) {
  std::vector<std::pair<double, double>> own, fixed_e;
  for (const double alpha : {0.1, 0.25, 0.4}) {
    own.emplace_back(alpha, bench.thresholds().mode_2(with_alpha(pulse_case(3), alpha)).value_or(0));
    fixed_e.emplace_back(alpha, bench.thresholds().mode_2(with_alpha(pulse_case(3), alpha, 0.9)).value_or(0));
  }
  const auto spread = [](const auto& v) { return std::abs(v.back().second - v.front().second); };
  const std::string found =
      fmt::format("ω_p/p = 3, after one impact, in αg by α: with e of (46) {}; with e = 0.9 {}", paired(own),
                  paired(fixed_e));
  if (spread(fixed_e) > 1e-9) return refuted(found, "They depend on α.");
  if (spread(own) < 1e-9) return confirmed(found, "They do not depend on α.");
  return qualified(found,
                   "True of the curves without impact, and of those with impact for a given e. But e of (46) "
                   "depends on α, and through it the curves do; so they do in the nonlinear model.");
}

}  // namespace

Checks checks_of_one_impact() {
  return {{"admissible_86_88", admissible_86_88},
          {"handover", handover},
          {"beyond_handover", beyond_handover},
          {"two_roots_of_96", two_roots_of_96},
          {"independent_of_alpha", independent_of_alpha}};
}

}  // namespace rederive
