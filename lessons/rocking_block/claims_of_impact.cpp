// Section 2: restitution, and the reactions while rocking.
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <lessons/rocking_block/claims_readings.hpp>
#include <numbers>

namespace rederive::rocking_block {
using namespace decide;
using namespace paper;
using namespace page;
using namespace ledger;

using namespace numerics;

namespace {

constexpr Real long_pi = std::numbers::pi_v<Real>;

/// Returns the phase at which a pulse begins. The motions begin later, at phase psi.
Real phase_0(Pulse pulse) { return pulse == Pulse::sine ? 0 : long_pi / 2; }

Finding pulse_start(Bench&, const Claim&) {
  const auto first = [](Pulse pulse) {
    const Piece piece = pulse_motion(pulse, 2, 2, 1).front();
    const Real time = piece.from + (phase_0(pulse) - piece.phase) / piece.omega;
    return static_cast<double>(ground_at(piece, time) / piece.amplitude);
  };
  const double sine = first(Pulse::sine), cosine = first(Pulse::cosine);
  return {decided(std::abs(sine) < 1e-12 && std::abs(cosine - 1) < 1e-12), {sine, cosine}};
}

/// Computes the velocity that the ground keeps after the pulse of section 3, taken from phase 0.
Finding cosine_is_whole(Bench&, const Claim&) {
  const auto end = [](Pulse pulse) {
    const Piece piece = pulse_motion(pulse, 2, 2, 1).front();
    return piece.phase + piece.omega * (piece.to - piece.from);
  };
  const auto velocity = [&](Pulse pulse) {  // the integral of the sine, in a_p/omega_p
    return static_cast<double>(std::cos(phase_0(pulse)) - std::cos(end(pulse)));
  };
  const double cycles = static_cast<double>(end(Pulse::cosine) / (2 * long_pi) - 0.25L);
  const double sine = velocity(Pulse::sine), cosine = velocity(Pulse::cosine);
  return {decided(std::abs(cosine) < 1e-9), {cycles, cosine, sine}};
}

Finding slower_after_impact(Bench&, const Claim&) {
  bool below_one = true;
  for (int i = 1; i <= 156; ++i) below_one = below_one && std::abs(emitted::restitution(i / 100.0)) < 1;
  return {decided(below_one),
          {each({0.1, 0.25, 0.5, 0.95, 1.0}, [](double alpha) { return emitted::restitution(alpha); })}};
}

Finding angle_of_stockiness(Bench&, const Claim&) {
  const double ratio = std::tan(paper_block().alpha), more = ratio / paper_block().alpha - 1;
  return {std::abs(more) < 1e-3 ? confirmed : qualified, {ratio, 100 * more}};
}

Finding smooth_impact(Bench& bench, const Claim&) {
  for (const Event& event : motion_at(pulse_case(3), bench.mode_2(pulse_case(3))).events)
    if (event.kind == EventKind::impact)
      return {decided(event.velocity_before == event.velocity_after),
              {static_cast<double>(event.velocity_before), static_cast<double>(event.velocity_after)}};
  throw std::logic_error("the critical motion of Fig. 12 has no impact");
}

Finding impact_loses_energy(Bench&, const Claim&) {
  const double e = emitted::restitution(0.25), lost = 1 - e * e;
  return {decided(lost > 0 && e < 1), {e, 100 * lost}};
}

Finding restitution_of_statues(Bench&, const Claim& claim) {
  const std::vector<Reading> readings{{"α = atan(0.11)", emitted::restitution(std::atan(0.11))},
                                      {"α = 0.11", emitted::restitution(0.11)}};
  const auto matches = compare_with(claim.printed, readings);
  bool holds = false;
  for (const Reading& fit : fitting(matches)) holds = holds || fit.value == readings.front().value;
  return {decided(holds), {summary(matches)}};
}

Finding both_sides(Bench& bench, const Claim&) {
  int left = 0, right = 0;
  for (const Sample& sample : samples_at(pulse_case(3, Model::nonlinear), 2))
    (sample.angle < 0 ? left : right) += sample.angle != 0;
  const Verdict verdict = bench.verdict_of("50");
  return {decided(right == 0 && verdict != Verdict::refuted),
          {to_string(verdict), 100.0 * right / (left + right)}};
}

Finding free_before(Bench&, const Claim&) {
  const Piece pulse = ground_of(pulse_case(2), 2).front();
  const double middle = static_cast<double>(ground_at(pulse, pulse.to / 4));
  return {decided(middle == 0), {middle}};
}

Finding slender_example(Bench&, const Claim&) {
  const double ratio = std::tan(paper_block().alpha);
  return {decided(ratio <= 0.25), {ratio}};
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

}  // namespace rederive::rocking_block
