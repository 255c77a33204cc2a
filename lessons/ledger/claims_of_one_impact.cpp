// Section 3: overturning after one impact in the linear model.
#include <fmt/format.h>

#include <cmath>
#include <lessons/ledger/claims_readings.hpp>

namespace rederive {

namespace {

Finding admissible_86_88(Bench&, const Claim& claim) {
  std::string found;
  int fine = 0, tried = 0;
  for (const double ratio : {0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 4.75}) {
    ++tried;
    for (const ClosedForm& root : roots_of(Form::eq86_88, pulse_case(ratio, Model::linear, 0.9)))
      if (root.admissible) {
        ++fine, add(found, fmt::format("{:g}: {:.4f}", ratio, root.amplitude));
        break;
      }
  }
  return {decided(fine == tried), {found, fine, tried, claim.printed}};
}

Finding handover(Bench& bench, const Claim& claim) {
  const auto matches = compare_with(claim.printed, handover_readings(bench));
  const double derived = bench.handover_of(pulse_case(1));
  bool own = false;
  for (const Reading& fit : fitting(matches)) own = own || std::abs(fit.value - derived) < 1e-12;
  return {own ? confirmed : fitting(matches).empty() ? refuted : qualified, {derived, summary(matches)}};
}

Finding beyond_handover(Bench&, const Claim&) {
  std::string found;
  bool all_late = true;
  for (const double ratio : {5.0, 5.5, 6.0, 8.0})
    for (const ClosedForm& root : roots_of(Form::eq86_88, pulse_case(ratio))) {
      all_late = all_late && !root.admissible && *root.impact_time > root.pulse_end;
      add(found, fmt::format("{:g}: {:.4f} > {:.4f}", ratio, *root.impact_time, root.pulse_end));
    }
  return {decided(all_late && !found.empty()), {found}};
}

Finding two_roots_of_96(Bench& bench, const Claim&) {
  const PulseCase asked = pulse_case(5.5);
  std::string found;
  int minima = 0, tried = 0;
  for (const ClosedForm& root : roots_of(Form::eq92a_96, asked)) {
    ++tried, minima += root.admissible;
    add(found, fmt::format("{:.4f} αg{}", root.amplitude, root.admissible ? "" : " (" + root.why_not + ")"),
        "; ");
  }
  return {minima == 1 && tried == 1 ? confirmed
          : minima == 0             ? refuted
                                    : qualified,
          {found, bench.mode_2(asked), bench.mode_2_upper(asked)}};
}

Finding independent_of_alpha(Bench& bench, const Claim&) {
  const auto threshold = [&](double alpha, std::optional<double> e) {
    return bench.mode_2(with_alpha(pulse_case(3), alpha, e));
  };
  const auto own = [&](double alpha) { return threshold(alpha, {}); };
  const auto with_e = [&](double alpha) { return threshold(alpha, 0.9); };
  const auto depends = [](const auto& of) { return std::abs(of(0.4) - of(0.1)) > 1e-9; };
  return {depends(with_e) ? refuted
          : depends(own)  ? qualified
                          : confirmed,
          {each({0.1, 0.25, 0.4}, own), each({0.1, 0.25, 0.4}, with_e)}};
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
