// Section 3: the thresholds of the one-sine pulse in the linear model.
#include <fmt/format.h>

#include <cmath>
#include <emitted/rocking_block.hpp>
#include <lessons/ledger/claims_checks.hpp>
#include <lessons/ledger/claims_motion.hpp>
#include <lessons/ledger/claims_thresholds.hpp>
#include <numbers>

namespace rederive {

namespace {

constexpr double pi = std::numbers::pi;

Finding threshold_71(Workbench& bench, const Claim&) {
  std::vector<std::pair<double, double>> roots;
  double largest = 0;
  for (const double ratio : {0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 6.0}) {
    const double root = roots_of(Form::eq71, pulse_case(ratio)).at(0).amplitude;
    roots.emplace_back(ratio, root);
    largest =
        std::max(largest, std::abs(bench.thresholds().mode_1(pulse_case(ratio)).value_or(0) / root - 1));
  }
  return decided(
      largest < 1e-9,
      fmt::format("roots of (71) by ω_p/p, in αg: {}; simulation differs by at most {:.0e} of that",
                  paired(roots), largest),
      "The root is the least amplitude of the linear block without impact.",
      "Simulation finds other thresholds.");
}

Finding admissible_71(Workbench& bench, const Claim&) {
  double highest = -1e9;
  for (const double ratio : {1.0, 2.0, 4.0})
    for (const Sample& sample :
         samples_at(pulse_case(ratio), bench.thresholds().mode_1(pulse_case(ratio)).value_or(2)))
      if (sample.time > 0.01L) highest = std::max(highest, static_cast<double>(sample.angle));
  return decided(
      highest < 0,
      fmt::format("ω_p/p = 1, 2, 4 at the threshold: θ/α at most {:.1e} from p·t = 0.01 to T_ex", highest),
      "θ stays negative.", "θ changes its sign.");
}

/// The critical motions at the end of the pulse: how far from the separatrix, and how far out.
Finding separatrix(Workbench& bench, const Claim& claim) {
  double off = 0, farthest = 0;
  for (const double ratio : {1.0, 2.0, 3.0, 4.0, 6.0}) {
    const PulseCase asked = pulse_case(ratio);
    for (const auto& amplitude :
         {bench.thresholds().mode_1(asked), ratio < 4.5 ? bench.thresholds().mode_2(asked) : std::nullopt}) {
      if (!amplitude) continue;
      const Point end = respond(asked.block, asked.model, ground_of(asked, *amplitude), asked.initial).end;
      const double side = end.angle < 0 ? -1 : 1;
      off = std::max(off, std::abs(static_cast<double>(end.velocity + end.angle) - side));
      farthest = std::max(farthest, std::abs(static_cast<double>(end.angle)));
    }
  }
  const std::string found = fmt::format(
      "ten critical motions: |θ̇/p + θ ∓ α| ≤ {:.0e} α at T_ex; |θ(T_ex)|/α up to {:.3f}", off, farthest);
  if (off > 1e-9) return refuted(found, "They end elsewhere.");
  if (claim.check == "separatrix_reason")
    return qualified(
        found,
        "The condition is right; its reason is not. Nothing oscillates about an unstable equilibrium and the "
        "block never arrives: the growing part of the free motion vanishes.");
  return confirmed(
      found, farthest > 1
                 ? "After the pulse they run along θ̇ = −p(θ ∓ α) towards the corner: ∓ for the side, θ = −α "
                   "for θ < 0. Some come from beyond it: the "
                   "block may pass α while the ground moves and still be critical."
                 : "After the pulse they run along θ̇ = −p(θ ∓ α) towards the corner: θ = −α for θ < 0.");
}

Finding roots_of_78(Workbench&, const Claim&) {
  double least = 1e9;
  std::string roots;
  for (const double ratio : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    for (int i = 1; i < 1000; ++i)
      least = std::min(least, emitted::overturning_without_impact_positive(ratio, i * pi / 2000));
    roots += fmt::format("{}{:g}: ψ = {:.4f}", roots.empty() ? "" : ", ", ratio,
                         roots_of(Form::eq78, pulse_case(ratio)).at(0).psi);
  }
  return decided(
      least <= 0,
      fmt::format("left side less right side of (78) for 0 < ψ < π/2: at least {:.4f}; roots by ω_p/p: {}",
                  least, roots),
      "It has roots where a pulse starts the block.",
      "It has no root with ψ < π/2, where a pulse sets the block in motion; those it has lie where the "
      "acceleration falls already. No amplitude goes with it.");
}

Finding admissible_78(Workbench&, const Claim&) {
  double highest = -1e9;
  for (const double ratio : {0.5, 1.0, 2.0, 4.0}) {
    const ClosedForm root = roots_of(Form::eq78, pulse_case(ratio)).at(0);
    if (root.admissible) return refuted("admissible at " + fixed(ratio, 1), "It occurs.");
    for (const double t : {0.01, 0.1}) {
      const double angle =
          emitted::linear_response_positive(0.25, 1.0, ratio, 0.25 * root.amplitude, root.psi, 0.0, 0.0, t);
      highest = std::max(highest, angle / 0.25);
    }
  }
  return decided(highest < 0,
                 fmt::format("motion by (57b) from rest with ψ of (78), ω_p/p = 0.5, 1, 2, 4: θ/α ≤ {:.1e} "
                             "at p·t = 0.01 and 0.1",
                             highest),
                 "θ turns negative at once, on the branch that is for θ > 0.", "θ is positive.");
}

Finding sides_under_sine(Workbench& bench, const Claim&) {
  int without = 0, after = 0;
  std::string found;
  for (const double ratio : {1.0, 2.0, 3.0, 5.5})
    for (const Window& window : bench.thresholds().windows(pulse_case(ratio))) {
      (std::abs(window.code) == 1 ? without : after) += 1;
      if (std::abs(window.code) == 1 && window.code != -1)
        return refuted(fmt::format("code {:+d} at ω_p/p = {:g}", window.code, ratio),
                       "Also without impact it falls to θ > 0.");
      if (window.code == 2)
        found += fmt::format("{}{:g}: {:.4f}", found.empty() ? "" : ", ", ratio, window.from);
    }
  if (found.empty()) return confirmed("codes −1 only", "It only falls to θ < 0.");
  return qualified(fmt::format("from rest: {} windows without impact, all to θ < 0; {} after impacts, to θ > "
                               "0, from (by ω_p/p, in αg) {}",
                               without, after, found),
                   "True of overturning without impact. After one impact it falls over O', to θ > 0, and at "
                   "smaller amplitudes.");
}

Finding pulse_of_other_sign(Workbench& bench, const Claim&) {
  int mirrored = 0, tried = 0;
  for (const double ratio : {1.0, 2.0, 4.0})
    for (const double share : {0.9999, 1.0001}) {
      const PulseCase asked = pulse_case(ratio);
      const double amplitude = bench.thresholds().mode_1(asked).value_or(2) * share;
      GroundMotion ground = ground_of(asked, amplitude);
      const int code = outcome_of(asked.block, asked.model, ground, asked.initial).code;
      ground.front().phase += pi;
      mirrored += outcome_of(asked.block, asked.model, ground, asked.initial).code == -code;
      ++tried;
    }
  return decided(
      mirrored == tried,
      fmt::format("{} of {} pairs of pulses of either sign, just below and above (71), end as mirror images",
                  mirrored, tried),
      "The same threshold, on the other side.", "They do not.");
}

/// Where the critical motion of Fig. 8 creeps to, under either sign of the pulse.
Finding end_of_portrait(Workbench& bench, const Claim&) {
  const PulseCase asked = pulse_case(2);
  GroundMotion ground = ground_of(asked, bench.thresholds().mode_1(asked).value_or(2));
  const auto corner = [&] {
    return respond(asked.block, asked.model, ground, asked.initial).end.angle < 0 ? -1 : 1;
  };
  const int positive = corner();
  ground.front().phase += pi;
  const int negative = corner();
  const std::string found = fmt::format(
      "corner of the critical motion of (71): {:+d} α under the positive pulse of (52), {:+d} α under the "
      "negative one",
      positive, negative);
  if (positive == 1) return confirmed(found, "At +α.");
  if (negative != 1) return refuted(found, "Never at +α.");
  return qualified(found,
                   "For the pulse as it is defined in (52) the corner is −α; +α needs the pulse reversed, or "
                   "the sign convention of the figure is another one.");
}

Finding independent_of_p(Workbench& bench, const Claim&) {
  PulseCase other = pulse_case(2);
  other.block.p = 5;
  const double here = bench.thresholds().mode_1(pulse_case(2)).value_or(0),
               there = roots_of(Form::eq71, other).at(0).amplitude;
  const double after = bench.thresholds().mode_2(pulse_case(2)).value_or(0);
  const int below = outcome_at(other, after * 0.9999).code, above = outcome_at(other, after * 1.0001).code;
  return decided(std::abs(here / there - 1) < 1e-9 && below != 2 && above == 2,
                 fmt::format("ω_p/p = 2, without impact: {:.6f} αg with p = 2.14, {:.6f} with p = 5; after "
                             "one impact from {:.4f} with either",
                             here, there, after),
                 "Against ω_p/p and p·t nothing depends on p; the value in the captions matters for periods "
                 "in seconds and for θ̇_0/p only.",
                 "They depend on p.");
}

Finding limit_of_tanh(Workbench&, const Claim&) {
  const double at_5 = 1 - std::tanh(5.0), at_10 = 1 - std::tanh(10.0);
  const std::string found =
      fmt::format("1 − tanh x = {:.1e} at x = 5, {:.1e} at x = 10; 0 nowhere", at_5, at_10);
  if (!(at_10 > 0)) return confirmed(found, "It becomes 1.");
  return qualified(found,
                   "It is approached, never reached; (67) and (74) are right as limits, and as the condition "
                   "that the growing part vanishes they need no large time.");
}

}  // namespace

Checks checks_of_linear_model() {
  return {{"threshold_71", threshold_71},
          {"admissible_71", admissible_71},
          {"separatrix", separatrix},
          {"separatrix_reason", separatrix},
          {"roots_of_78", roots_of_78},
          {"admissible_78", admissible_78},
          {"sides_under_sine", sides_under_sine},
          {"pulse_of_other_sign", pulse_of_other_sign},
          {"end_of_portrait", end_of_portrait},
          {"independent_of_p", independent_of_p},
          {"limit_of_tanh", limit_of_tanh}};
}

}  // namespace rederive
