// Section 2: restitution, and the reactions while rocking.
#include <fmt/format.h>

#include <cmath>
#include <emitted/rocking_block.hpp>
#include <lessons/ledger/claims_checks.hpp>
#include <lessons/ledger/claims_motion.hpp>
#include <lessons/ledger/claims_readings.hpp>
#include <numbers>

namespace rederive {

namespace {

Finding pulse_start(Workbench&, const Claim&) {
  // Phase 0 of either pulse, as the share of its amplitude: the motions begin at psi, so go back to phase 0.
  const auto first = [](Pulse pulse) {
    const Piece piece = pulse_motion(pulse, 2, 2, 1).front();
    const Real phase_0 = pulse == Pulse::sine ? 0 : std::numbers::pi_v<Real> / 2;
    return static_cast<double>(ground_at(piece, piece.from + (phase_0 - piece.phase) / piece.omega) /
                               piece.amplitude);
  };
  const double sine = first(Pulse::sine), cosine = first(Pulse::cosine);
  return decided(std::abs(sine) < 1e-12 && std::abs(cosine - 1) < 1e-12,
                 fmt::format("ü_g/a_p at phase 0: sine {:.3f}, cosine {:.3f}", sine, cosine), "So they do.",
                 "They do not.");
}

/// The pulse of section 3 taken from phase 0: what velocity does the ground keep?
Finding cosine_is_whole(Workbench&, const Claim&) {
  const auto velocity = [](Pulse pulse) {
    const Piece piece = pulse_motion(pulse, 2, 2, 1).front();
    const Real shift = pulse == Pulse::sine ? 0 : std::numbers::pi_v<Real> / 2;
    const Real from = shift, to = piece.phase + piece.omega * (piece.to - piece.from);
    return static_cast<double>(std::cos(from) - std::cos(to));  // the integral of the sine, in a_p/omega_p
  };
  const Piece piece = pulse_motion(Pulse::cosine, 2, 2, 1).front();
  const double cycles = static_cast<double>((piece.phase + piece.omega * (piece.to - piece.from)) /
                                            (2 * std::numbers::pi_v<Real>)-0.25L);
  const double sine = velocity(Pulse::sine), cosine = velocity(Pulse::cosine);
  return decided(std::abs(cosine) < 1e-9,
                 fmt::format("T_ex = (3π/2 − ψ)/ω_p ends after {:.2f} of a cycle; ground velocity left over: "
                             "{:.3f} a_p/ω_p (one-sine: {:.3f})",
                             cycles, cosine, sine),
                 "It is a whole cycle.",
                 "It breaks off after three quarters of a cycle, where the acceleration happens to vanish, "
                 "and leaves the ground moving; the one-cosine pulse of "
                 "Fig. 6 is a whole cycle and ends at rest.");
}

Finding slower_after_impact(Workbench&, const Claim&) {
  std::vector<std::pair<double, double>> values;
  bool below_one = true;
  for (int i = 1; i <= 156; ++i) below_one = below_one && std::abs(emitted::restitution(i / 100.0)) < 1;
  for (const double a : {0.1, 0.25, 0.5, 0.95, 1.0}) values.emplace_back(a, emitted::restitution(a));
  return decided(below_one, "e of (46) by α: " + paired(values),
                 "For every shape; for α above 0.955 (sin² α > 2/3) e is negative, and the block does not go "
                 "on to rock.",
                 "Not for every shape.");
}

Finding angle_of_stockiness(Workbench&, const Claim&) {
  const double ratio = std::tan(paper_block().alpha);
  const std::string found = fmt::format("α = 0.25: b/h = tan α = {:.5f}, {:.1f} % more", ratio,
                                        100 * (ratio / paper_block().alpha - 1));
  if (std::abs(ratio / paper_block().alpha - 1) < 1e-3) return confirmed(found, "To three digits.");
  return qualified(found,
                   "To first order only: the inverse of the slenderness is tan α. The difference is the one "
                   "between the units αg and g·tan α on which the numbers of section 4 turn.");
}

Finding smooth_impact(Workbench& bench, const Claim&) {
  const PulseCase asked = pulse_case(3);
  ResponseOptions options;
  options.history = true;
  const Response motion =
      respond(asked.block, asked.model, ground_of(asked, bench.thresholds().mode_2(asked).value_or(2)),
              asked.initial, options);
  for (const Event& event : motion.events)
    if (event.kind == EventKind::impact)
      return decided(
          event.velocity_before == event.velocity_after,
          fmt::format("at the impact of Fig. 12 θ̇/(αp) falls from {:.4f} to {:.4f}",
                      static_cast<double>(event.velocity_before), static_cast<double>(event.velocity_after)),
          "It is smooth.",
          "The angle is continuous; the angular velocity jumps by the factor e, as the next sentences say.");
  return undecided("no impact", "The motion has none.");
}

Finding impact_loses_energy(Workbench&, const Claim&) {
  const double e = emitted::restitution(0.25), lost = 1 - e * e;
  return decided(lost > 0 && e < 1, fmt::format("α = 0.25: e = {:.5f}, energy lost {:.2f} %", e, 100 * lost),
                 "An impact takes energy.", "It does not.");
}

Finding restitution_of_statues(Workbench&, const Claim& claim) {
  const std::vector<Reading> readings{{"α = atan(0.11)", emitted::restitution(std::atan(0.11))},
                                      {"α = 0.11", emitted::restitution(0.11)}};
  const auto matches = compare_with(claim.printed, readings);
  for (const Match& match : matches)
    if (match.reading.says == readings.front().says && match.rounds)
      return confirmed(summary(matches), "By (46).");
  return refuted(summary(matches), "Not by (46) with the angle that is printed.");
}

Finding both_sides(Workbench& bench, const Claim&) {
  const PulseCase asked = pulse_case(3, Model::nonlinear);
  int left = 0, right = 0;
  for (const Sample& sample : samples_at(asked, 2)) (sample.angle < 0 ? left : right) += sample.angle != 0;
  const double share = 100.0 * right / (left + right);
  const bool covers = right == 0 && row_verdict(bench, "50") != "refuted";
  return decided(covers,
                 fmt::format("(50) {}; it is for θ < 0, and at ω_p/p = 3, 2 αg the block spends {:.0f} % of "
                             "the rocking during the pulse at θ > 0",
                             row_verdict(bench, "50"), share),
                 "It does.",
                 "Even corrected (row r5) it covers one side only; row r6 is the condition for θ > 0.");
}

Finding free_before(Workbench&, const Claim&) {
  const PulseCase asked = pulse_case(2);
  const GroundMotion ground = ground_of(asked, 2);
  const double middle = static_cast<double>(ground_at(ground.front(), ground.front().to / 4));
  return decided(
      middle == 0,
      fmt::format("ω_p/p = 2, 2 αg: a quarter of the way to T_ex the ground acceleration is {:.3f} αg",
                  middle),
      "It is free.",
      "The motion is free for t_0 ≤ t ≤ t* only, t_0 being the end of the pulse or a later impact; before "
      "that it is forced.");
}

Finding slender_example(Workbench&, const Claim&) {
  const double ratio = std::tan(paper_block().alpha);
  return decided(ratio <= 0.25, fmt::format("α = 0.25: b/h = tan α = {:.4f}", ratio), "It is.",
                 "All examples lie just outside the range that the text gives for the linear equations: α = "
                 "0.25 is taken for b/h = 0.25.");
}

}  // namespace

Checks checks_of_impact() {
  return {{"pulse_start", pulse_start},
          {"angle_of_stockiness", angle_of_stockiness},
          {"smooth_impact", smooth_impact},
          {"cosine_is_whole", cosine_is_whole},
          {"slower_after_impact", slower_after_impact},
          {"impact_loses_energy", impact_loses_energy},
          {"restitution_of_statues", restitution_of_statues},
          {"both_sides", both_sides},
          {"free_before", free_before},
          {"slender_example", slender_example}};
}

}  // namespace rederive
