// Does the block really move as a closed form assumes?
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <numerics/motion/arc.hpp>
#include <numerics/search/closed_form.hpp>

namespace rederive::numerics {
namespace {

/// What the phase alone forbids.
std::string wrong_start(Form form, Pulse pulse, Real psi) {
  if (pulse == Pulse::cosine)
    return psi >= 0 ? "" : "the crest comes after the start: this phase asks for a pulse that has passed it";
  if (psi <= std::numbers::pi / 2) return "";
  return std::string("the pulse falls from the start: a block at rest does not move then") +
         (form == Form::eq78 ? ", and under one that rises it turns to the left, not to the right" : "");
}

std::string wrong_side_of_pulse_end(Form form, Real impact, Real end) {
  if (form == Form::eq86_88 && impact >= end)
    return fmt::format("the impact comes too late: at {:.6g}, after the pulse ends at {:.6g}", impact, end);
  if (form == Form::eq92a_96 && impact <= end)
    return fmt::format("the impact comes too early: at {:.6g}, before the pulse ends at {:.6g}", impact, end);
  return "";
}

/// Where the first motion takes the block: -1, +1, or 0 if it stays at rest.
int side_taken(Pulse pulse, const ExactCase& exact) {
  const Ball& leads = exact.angle.is_zero() ? exact.velocity : exact.angle;
  if (leads.is_zero()) return pulse == Pulse::sine ? -1 : 0;
  return leads.is_negative() ? -1 : 1;
}

/// To 15 digits, or so many behind the point.
Real certain(const Ball& number) {
  const Real value = number.to_real(), width = (number.upper() - number.lower()).to_real();
  if (!(width < 1e-15L * (1 + std::abs(value)))) throw NotCertain("the motion at a root is not certain");
  return value;
}

/// theta/alpha and thetadot/(alpha p), after a time in which the ground moves as amplitude sin(w t + phase).
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

/// The motion at a root: where the pulse begins, on which side, and its first arc and that after an impact.
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
  /// The arc from `start` at `begin`, when the phase is `phase`.
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

std::string other_motion(Form form, Pulse pulse, const ExactCase& exact, const ExactRoot& root) {
  const int side = side_taken(pulse, exact), code = code_of(form);
  if (side == 0) return "from rest the block stays at rest: the ground acceleration falls at once";
  if (side != (code == 1 ? 1 : -1))
    return fmt::format("theta has the other sign: the motion starts with theta {} 0", side < 0 ? "<" : ">");
  const RootMotion motion(pulse, exact, root, side);
  const Real impact = root.impact_time.to_real();
  const bool during = form == Form::eq86_88;
  const Arc first = during ? motion.first_arc(impact * (1 - 1e-9L)) : motion.first_arc();
  if (first.kind == ArcEnd::impact)
    return code == 2
               ? fmt::format("the first impact is at {:.6g}, not at {:.6g}", first.end.time, impact)
               : fmt::format("theta changes sign: impact at {:.6g}, before the pulse ends", first.end.time);
  if (!during) return "";
  const Arc second = motion.arc_after_impact();
  if (second.kind != ArcEnd::impact) return "";
  return fmt::format("a second impact follows at {:.6g}, before the pulse ends", second.end.time);
}

}  // namespace

std::string contradiction(Form form, Pulse pulse, const ExactCase& exact, const ExactRoot& root) {
  std::string reason = wrong_start(form, pulse, root.psi.to_real());
  if (reason.empty())
    reason = wrong_side_of_pulse_end(form, root.impact_time.to_real(), root.pulse_end.to_real());
  return reason.empty() ? other_motion(form, pulse, exact, root) : reason;
}

}  // namespace rederive::numerics
