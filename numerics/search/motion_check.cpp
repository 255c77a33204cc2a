#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numerics/motion/reference.hpp>
#include <numerics/search/ball_functions.hpp>
#include <numerics/search/closed_form.hpp>

namespace rederive::numerics {
using namespace numbers;
namespace {

using Kind = Objection::Kind;

/// Returns what the phase alone forbids.
std::optional<Objection> wrong_start(Form form, Pulse pulse, Real psi) {
  if (pulse == Pulse::cosine)
    return psi >= 0 ? std::nullopt : std::optional(Objection{Kind::crest_comes_later});
  if (psi <= std::numbers::pi / 2) return std::nullopt;
  return Objection{form == Form::eq78 ? Kind::falls_from_start_or_goes_left : Kind::falls_from_start};
}

std::optional<Objection> wrong_side_of_pulse_end(Form form, Real impact, Real end) {
  if (form == Form::eq86_88 && impact >= end) return Objection{Kind::impact_too_late, impact, end};
  if (form == Form::eq92a_96 && impact <= end) return Objection{Kind::impact_too_early, impact, end};
  return std::nullopt;
}

/// Returns the side to which the first motion takes the block: -1 or +1, or 0 if the block stays at rest.
int side_taken(Pulse pulse, const ExactCase& exact) {
  const Ball& leads = exact.angle.is_zero() ? exact.velocity : exact.angle;
  if (leads.is_zero()) return pulse == Pulse::sine ? -1 : 0;
  return leads.is_negative() ? -1 : 1;
}

/// Returns the number with 15 digits, or with a given number of digits after the point.
Real certain(const Ball& number) {
  const Real value = number.to_real(), width = (number.upper() - number.lower()).to_real();
  if (!(width < 1e-15L * (1 + std::abs(value)))) throw NotCertain("the motion at a root is not certain");
  return value;
}

/// The state theta/alpha, thetadot/(alpha p) after a time in which the acceleration of the ground is
/// amplitude sin(w t + phase).
struct State {
  Ball angle, velocity;
};

State moved(const ExactCase& exact, const Ball& amplitude, const Ball& phase, int side, const State& from,
            const Ball& time) {
  const Ball one(1), &w = exact.omega_ratio;
  const auto state = [](const auto& at) { return State{at.value, at.d_t}; };
  return side < 0 ? state(emitted::linear_response_negative_with_derivatives(one, one, w, amplitude, phase,
                                                                             from.angle, from.velocity, time))
                  : state(emitted::linear_response_positive_with_derivatives(
                        one, one, w, amplitude, phase, from.angle, from.velocity, time));
}

/// The motion at a root: where the pulse begins, the side of the block, its first arc, and the arc after an
/// impact.
class RootMotion {
 public:
  RootMotion(Pulse pulse, const ExactCase& exact, const ExactRoot& root, int side)
      : exact_(exact),
        root_(root),
        side_(side),
        phase_(pulse == Pulse::sine ? root.psi : root.psi + emitted::pi<Ball>() / Ball(2)),
        piece_(
            pulse_motion(pulse, exact.omega_ratio.to_real(), std::max<Real>(1, root.amplitude.to_real()), 1)
                .front()) {}

  Arc first_arc(Real until) const {
    return arc(side_, phase_, Ball(0).at(exact_.angle.bits()), {exact_.angle, exact_.velocity}, until);
  }
  Arc first_arc() const { return first_arc(piece_.to); }

  Arc arc_after_impact() const {
    const Ball& time = root_.impact_time;
    const State before = moved(exact_, root_.amplitude, phase_, side_, {exact_.angle, exact_.velocity}, time);
    return arc(-side_, phase_ + exact_.omega_ratio * time, time,
               {Ball(0), exact_.restitution * before.velocity}, piece_.to);
  }

 private:
  /// Returns the arc from `start` at the time `begin`, when the phase is `phase`.
  Arc arc(int side, const Ball& phase, const Ball& begin, const State& start, Real until) const {
    Mover mover([&](const Arc&, const Point&, Real time) {
      const State at = moved(exact_, root_.amplitude, phase, side, start, Ball(time, begin.bits()) - begin);
      return Point{time, certain(at.angle), certain(at.velocity)};
    });
    return mover.move(piece_, side, {begin.to_real(), start.angle.to_real(), start.velocity.to_real()},
                      until);
  }

  const ExactCase& exact_;
  const ExactRoot& root_;
  int side_;
  Ball phase_;
  Piece piece_;
};

std::optional<Objection> other_motion(Form form, Pulse pulse, const ExactCase& exact, const ExactRoot& root) {
  const int side = side_taken(pulse, exact), code = code_of(form);
  if (side == 0) return Objection{Kind::stays_at_rest};
  if (side != (code == 1 ? 1 : -1)) return Objection{side < 0 ? Kind::starts_to_left : Kind::starts_to_right};
  const RootMotion motion(pulse, exact, root, side);
  const Real impact = root.impact_time.to_real();
  const bool during = form == Form::eq86_88;
  const Arc first = during ? motion.first_arc(impact * (1 - 1e-9L)) : motion.first_arc();
  if (first.kind == ArcEnd::impact)
    return code == 2 ? Objection{Kind::other_first_impact, first.end.time, impact}
                     : Objection{Kind::changes_sign, first.end.time};
  if (!during) return std::nullopt;
  const Arc second = motion.arc_after_impact();
  if (second.kind != ArcEnd::impact) return std::nullopt;
  return Objection{Kind::second_impact, second.end.time};
}

}  // namespace

std::string ObjectionWords::in_full() const { return detail.empty() ? brief : brief + ": " + detail; }

ObjectionWords words_for(const Objection& objection) {
  const Real time = objection.time, other = objection.other;
  switch (objection.kind) {
    case Kind::crest_comes_later:
      return {"the crest comes after the start", "this phase asks for a pulse that has passed it"};
    case Kind::falls_from_start:
      return {"the pulse falls from the start", "a block at rest does not move then"};
    case Kind::falls_from_start_or_goes_left:
      return {"the pulse falls from the start",
              "a block at rest does not move then, and under one that rises it turns to the left, not to the "
              "right"};
    case Kind::impact_too_late:
      return {"the impact comes too late",
              fmt::format("at {:.6g}, after the pulse ends at {:.6g}", time, other)};
    case Kind::impact_too_early:
      return {"the impact comes too early",
              fmt::format("at {:.6g}, before the pulse ends at {:.6g}", time, other)};
    case Kind::stays_at_rest:
      return {"from rest the block stays at rest", "the ground acceleration falls at once"};
    case Kind::starts_to_left:
      return {"theta has the other sign", "the motion starts with theta < 0"};
    case Kind::starts_to_right:
      return {"theta has the other sign", "the motion starts with theta > 0"};
    case Kind::other_first_impact:
      return {fmt::format("the first impact is at {:.6g}, not at {:.6g}", time, other), ""};
    case Kind::changes_sign:
      return {"theta changes sign", fmt::format("impact at {:.6g}, before the pulse ends", time)};
    case Kind::second_impact:
      return {fmt::format("a second impact follows at {:.6g}, before the pulse ends", time), ""};
    case Kind::upper_edge:
      return {"not a minimum", "it overturns below this amplitude and not above"};
  }
  return {};
}

std::optional<Objection> objection_to(Form form, Pulse pulse, const ExactCase& exact, const ExactRoot& root) {
  if (const auto wrong = wrong_start(form, pulse, root.psi.to_real())) return wrong;
  const Real impact = root.impact_time.to_real(), end = root.pulse_end.to_real();
  if (const auto wrong = wrong_side_of_pulse_end(form, impact, end)) return wrong;
  return other_motion(form, pulse, exact, root);
}

}  // namespace rederive::numerics
