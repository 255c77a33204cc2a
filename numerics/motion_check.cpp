#include <numerics/motion_check.hpp>

#include <numerics/arc.hpp>
#include <numerics/closed_form_residuals.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <numbers>
#include <utility>

namespace rederive::inline numeric {
namespace {

/// The side on which the motion begins.
int first_side(Form form) { return code_of(form) == 1 ? 1 : -1; }

bool has_impact(Form form) { return std::abs(code_of(form)) == 2; }

/// A root, rounded.
struct Rounded {
  Form form;
  Pulse pulse;
  Real amplitude, psi, impact_time, pulse_end;
};

/// What the phase alone forbids.
std::string wrong_start(const Rounded& root) {
  if (root.pulse == Pulse::cosine)
    return root.psi >= 0 ? "" : "psi < 0: the ground acceleration has its crest after the start, not before";
  if (root.psi <= std::numbers::pi / 2) return "";
  return root.form == Form::eq78
             ? "psi > pi/2: the ground acceleration falls from the start, a block at rest does not move "
               "then, "
               "and under a rising one it turns to theta < 0, not to theta > 0"
             : "psi > pi/2: the ground acceleration falls from the start, a block at rest does not move then";
}

std::string wrong_side_of_pulse_end(const Rounded& root) {
  if (root.form == Form::eq86_88 && root.impact_time >= root.pulse_end)
    return fmt::format("t_i > T_ex: impact at {:.6g}, after the pulse ends at {:.6g}", root.impact_time,
                       root.pulse_end);
  if (root.form == Form::eq92a_96 && root.impact_time <= root.pulse_end)
    return fmt::format("t_i < T_ex: impact at {:.6g}, before the pulse ends at {:.6g}", root.impact_time,
                       root.pulse_end);
  return "";
}

/// Where the first motion takes the block: -1, +1, or 0 if it stays at rest.
int side_taken(Pulse pulse, const ExactCase& exact) {
  const Real angle = exact.angle.to_real(), leads = angle != 0 ? angle : exact.velocity.to_real();
  if (leads == 0) return pulse == Pulse::sine ? -1 : 0;
  return leads < 0 ? -1 : 1;
}

/// The motion under amplitude sin(w t + phase) from `angle` and `velocity` at `start`.
struct ExactMotion {
  Digits w, amplitude, phase, start, angle, velocity;

  /// theta/alpha and thetadot/(alpha p)
  std::pair<Digits, Digits> at(int side, const Digits& time) const {
    const Digits one = 1;
    const auto both = [](const auto& state) { return std::pair(state.value, state.d_t); };
    return side < 0 ? both(emitted::linear_response_negative_with_derivatives(one, one, w, amplitude, phase,
                                                                              angle, velocity, time - start))
                    : both(emitted::linear_response_positive_with_derivatives(one, one, w, amplitude, phase,
                                                                              angle, velocity, time - start));
  }
};

Arc followed(const ExactMotion& motion, const Piece& piece, int side, Real until) {
  const Point start{motion.start.to_real(), motion.angle.to_real(), motion.velocity.to_real()};
  Mover mover([&](const Arc& arc, const Point&, Real time) {
    const auto [angle, velocity] = motion.at(arc.side, Digits(time));
    return Point{time, angle.to_real(), velocity.to_real()};
  });
  return mover.move(piece, side, start, until);
}

std::string other_motion(const Rounded& rounded, const ExactCase& exact, const ExactRoot& root) {
  const int side = side_taken(rounded.pulse, exact);
  if (side == 0) return "from rest the block stays at rest: the ground acceleration falls at once";
  if (side != first_side(rounded.form))
    return fmt::format("theta has the other sign: the motion starts with theta {} 0", side < 0 ? "<" : ">");
  const Piece piece =
      pulse_motion(rounded.pulse, exact.omega_ratio.to_real(), std::max<Real>(1, rounded.amplitude), 1)
          .front();
  const Digits quarter = Digits::pi() / Digits(2);
  ExactMotion motion{
      exact.omega_ratio, root.amplitude, rounded.pulse == Pulse::sine ? root.psi : root.psi + quarter, 0,
      exact.angle,       exact.velocity};
  const bool during = rounded.form == Form::eq86_88;
  const Arc first = followed(motion, piece, side, during ? rounded.impact_time * (1 - 1e-9L) : piece.to);
  if (first.kind == ArcEnd::impact && has_impact(rounded.form))
    return fmt::format("the first impact is at {:.6g}, not at {:.6g}", first.end.time, rounded.impact_time);
  if (first.kind == ArcEnd::impact)
    return fmt::format("theta changes sign: impact at {:.6g}, before the pulse ends", first.end.time);
  if (!during) return "";
  const Digits after = exact.restitution * motion.at(side, root.impact_time).second;
  motion = {exact.omega_ratio,
            root.amplitude,
            motion.phase + exact.omega_ratio * root.impact_time,
            root.impact_time,
            0,
            after};
  const Arc second = followed(motion, piece, -side, piece.to);
  if (second.kind != ArcEnd::impact) return "";
  return fmt::format("a second impact follows at {:.6g}, before the pulse ends", second.end.time);
}

/// Whether the block overturns where the residual is positive, or where it is negative.
bool overturns_where_positive(Form form) {
  return form == Form::eq71 || form == Form::eq104 || form == Form::eq92a_96;
}

/// How the residual changes with psi, the impact moving along.
Digits change_with_psi(Form form, const ExactCase& exact, const ExactRoot& root) {
  const Inputs<Digits> in{exact.omega_ratio, exact.restitution, exact.angle + exact.velocity};
  if (!has_impact(form)) return residual_of_psi(form, in, root.psi).d_psi;
  const auto at = residuals_with_impact(form, in, root.psi, root.impact_time);
  return at.d_psi[1] - at.d_tau[1] * at.d_psi[0] / at.d_tau[0];
}

/// Amplitudes just above a root overturn, those just below do not; or the other way round.
bool overturns_above(const Rounded& rounded, const ExactCase& exact, const ExactRoot& root) {
  const bool psi_grows = rounded.pulse == Pulse::cosine;  // with the amplitude
  const bool residual_grows = (change_with_psi(rounded.form, exact, root) > 0) == psi_grows;
  return residual_grows == overturns_where_positive(rounded.form);
}

}  // namespace

Motion motion_at(Form form, Pulse pulse, const ExactCase& exact, const ExactRoot& root) {
  const Rounded rounded{form,
                        pulse,
                        root.amplitude.to_real(),
                        root.psi.to_real(),
                        root.impact_time.to_real(),
                        root.pulse_end.to_real()};
  if (std::string reason = wrong_start(rounded); !reason.empty()) return {false, reason};
  if (std::string reason = wrong_side_of_pulse_end(rounded); !reason.empty()) return {false, reason};
  if (std::string reason = other_motion(rounded, exact, root); !reason.empty()) return {false, reason};
  if (overturns_above(rounded, exact, root)) return {true, ""};
  return {true, "not a minimum: it overturns below this amplitude and not above"};
}

}  // namespace rederive::numeric
