// Section 3: the thresholds of the one-sine pulse in the linear model, without and after one impact.
#include <fmt/format.h>

#include <cmath>
#include <emitted/rocking_block.hpp>
#include <lessons/rocking_block/claims_readings.hpp>
#include <numbers>

namespace rederive::rocking_block {
using namespace numbers;
using namespace paper;
using namespace ledger;

using namespace numerics;

namespace {

using std::numbers::pi;

Finding threshold_71(Bench& bench, const Claim&) {
  double largest = 0;
  const std::string roots = each({0.2, 0.5, 1, 2, 3, 4, 6}, [&](double ratio) {
    const double root = root_of(Form::eq71, pulse_case(ratio)).amplitude;
    largest = std::max(largest, std::abs(bench.mode_1(pulse_case(ratio)) / root - 1));
    return root;
  });
  return {decided(largest < 1e-9), {roots, largest}};
}

Finding admissible_71(Bench& bench, const Claim&) {
  double highest = -1e9;
  for (const double ratio : {1.0, 2.0, 4.0})
    for (const Sample& sample : samples_at(pulse_case(ratio), bench.mode_1(pulse_case(ratio))))
      if (sample.time > 0.01L) highest = std::max(highest, static_cast<double>(sample.angle));
  return {decided(highest < 0), {highest}};
}

/// Computes how far the critical motions are from the separatrix at the end of the pulse, and from upright.
template <ClaimVerdict if_on_it>
Finding separatrix(Bench& bench, const Claim&) {
  double off = 0, farthest = 0;
  for (const double ratio : {1.0, 2.0, 3.0, 4.0, 6.0})
    for (const int impacts : {0, 1}) {
      const PulseCase asked = pulse_case(ratio);
      if (impacts == 1 && ratio > 4.5) continue;
      const numerics::Point end = motion_at(asked, bench.mode(impacts, asked)).end;
      const double side = end.angle < 0 ? -1 : 1;
      off = std::max(off, std::abs(static_cast<double>(end.velocity + end.angle) - side));
      farthest = std::max(farthest, std::abs(static_cast<double>(end.angle)));
    }
  const char* beyond =
      " Some come from beyond it: the block may pass α while the ground moves and still be critical.";
  return {off > 1e-9 ? refuted : if_on_it, {off, farthest, farthest > 1 ? beyond : ""}};
}

Finding roots_of_78(Bench&, const Claim&) {
  double least = 1e9;
  const std::string roots = each({0.5, 1, 2, 4, 8}, [&](double ratio) {
    for (int i = 1; i < 1000; ++i)
      least = std::min(least, emitted::overturning_without_impact_positive(ratio, i * pi / 2000));
    return fmt::format("ψ = {:.4f}", root_of(Form::eq78, pulse_case(ratio)).psi);
  });
  return {decided(least <= 0), {least, roots}};
}

Finding admissible_78(Bench&, const Claim&) {
  double highest = -1e9;
  bool occurs = false;
  for (const double ratio : {0.5, 1.0, 2.0, 4.0}) {
    const ClosedForm root = root_of(Form::eq78, pulse_case(ratio));
    occurs = occurs || root.admissible();
    for (const double t : {0.01, 0.1})
      highest = std::max(highest, emitted::linear_response_positive(0.25, 1.0, ratio, 0.25 * root.amplitude,
                                                                    root.psi, 0.0, 0.0, t) /
                                      0.25);
  }
  return {decided(highest < 0 && !occurs), {highest}};
}

Finding sides_under_sine(Bench& bench, const Claim&) {
  int without = 0, after = 0, wrong = 0;
  std::string found;
  for (const double ratio : {1.0, 2.0, 3.0, 5.5})
    for (const Window& window : bench.windows(pulse_case(ratio))) {
      (std::abs(window.code) == 1 ? without : after) += 1;
      wrong += window.code == 1;
      if (window.code == 2) add(found, fmt::format("{:g}: {:.4f}", ratio, window.from));
    }
  return {wrong > 0       ? refuted
          : found.empty() ? confirmed
                          : qualified,
          {without, wrong == 0 ? "all" : "not all", after, found}};
}

/// Returns the pulse with its sign changed.
GroundMotion reversed(GroundMotion ground) {
  ground.front().phase += pi;
  return ground;
}

Finding pulse_of_other_sign(Bench& bench, const Claim&) {
  int mirrored = 0, tried = 0;
  for (const double ratio : {1.0, 2.0, 4.0})
    for (const double share : {0.9999, 1.0001}) {
      const PulseCase asked = pulse_case(ratio);
      const GroundMotion ground = ground_of(asked, bench.mode_1(asked) * share);
      const auto code = [&](const GroundMotion& motion) {
        return outcome_of(asked.block, asked.model, motion, asked.initial).code;
      };
      ++tried, mirrored += code(reversed(ground)) == -code(ground);
    }
  return {decided(mirrored == tried), {mirrored, tried}};
}

/// Finds the corner that the critical motion of Fig. 8 approaches, under either sign of the pulse.
Finding end_of_portrait(Bench& bench, const Claim&) {
  const PulseCase asked = pulse_case(2);
  const GroundMotion ground = ground_of(asked, bench.mode_1(asked));
  const auto corner = [&](const GroundMotion& motion) {
    return respond(asked.block, asked.model, motion, asked.initial).end.angle < 0 ? -1 : 1;
  };
  const int positive = corner(ground), negative = corner(reversed(ground));
  return {positive == 1 ? confirmed : negative != 1 ? refuted : qualified, {positive, negative}};
}

Finding independent_of_p(Bench& bench, const Claim&) {
  PulseCase other = pulse_case(2);
  other.block.p = 5;
  const double here = bench.mode_1(pulse_case(2)), there = root_of(Form::eq71, other).amplitude,
               after = bench.mode_2(pulse_case(2));
  const int below = outcome_at(other, after * 0.9999).code, above = outcome_at(other, after * 1.0001).code;
  return {decided(std::abs(here / there - 1) < 1e-9 && below != 2 && above == 2), {here, there, after}};
}

Finding limit_of_tanh(Bench&, const Claim&) {
  const double at_5 = 1 - std::tanh(5.0), at_10 = 1 - std::tanh(10.0);
  return {at_10 > 0 ? qualified : confirmed, {at_5, at_10}};
}

Finding admissible_86_88(Bench&, const Claim& claim) {
  std::string found;
  int fine = 0, tried = 0;
  for (const double ratio : {0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 4.75}) {
    ++tried;
    for (const ClosedForm& root : roots_of(Form::eq86_88, pulse_case(ratio, Model::linear, 0.9)))
      if (root.admissible()) {
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
      all_late = all_late && !root.admissible() && *root.impact_time > root.pulse_end;
      add(found, fmt::format("{:g}: {:.4f} > {:.4f}", ratio, *root.impact_time, root.pulse_end));
    }
  return {decided(all_late && !found.empty()), {found}};
}

Finding two_roots_of_96(Bench& bench, const Claim&) {
  const PulseCase asked = pulse_case(5.5);
  std::string found;
  int minima = 0, tried = 0;
  for (const ClosedForm& root : roots_of(Form::eq92a_96, asked)) {
    ++tried, minima += root.admissible();
    add(found,
        fmt::format("{:.4f} αg{}", root.amplitude,
                    root.why_not ? " (" + words_for(*root.why_not).in_full() + ")" : ""),
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

Checks checks_of_linear_model() {
  return {{"threshold_71", threshold_71},
          {"admissible_71", admissible_71},
          {"separatrix", separatrix<confirmed>},
          {"separatrix_reason", separatrix<qualified>},
          {"roots_of_78", roots_of_78},
          {"admissible_78", admissible_78},
          {"sides_under_sine", sides_under_sine},
          {"pulse_of_other_sign", pulse_of_other_sign},
          {"end_of_portrait", end_of_portrait},
          {"independent_of_p", independent_of_p},
          {"limit_of_tanh", limit_of_tanh},
          {"admissible_86_88", admissible_86_88},
          {"handover", handover},
          {"beyond_handover", beyond_handover},
          {"two_roots_of_96", two_roots_of_96},
          {"independent_of_alpha", independent_of_alpha}};
}

}  // namespace rederive::rocking_block
