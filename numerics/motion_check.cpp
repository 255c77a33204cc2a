#include <numerics/motion_check.hpp>

#include <fmt/format.h>

#include <cmath>
#include <numbers>

namespace rederive::inline numeric {
namespace {

constexpr Real same_time = 1e-6L;  ///< relative: the closed form's impact and the simulated one are the same

bool has_impact(Form form) { return form == Form::eq86_88 || form == Form::eq92a_96; }

int side_of(Form form) {
  const bool to_positive = form == Form::eq78 || form == Form::eq103 || has_impact(form);
  return to_positive ? 1 : -1;
}

/// What the phase alone forbids.
std::string wrong_start(const PulseCase& linear, const Root& root) {
  if (linear.pulse == Pulse::cosine)
    return root.psi >= 0 ? "" : "psi < 0: the ground acceleration has its crest after the start, not before";
  if (root.psi <= std::numbers::pi / 2) return "";
  return root.form == Form::eq78
             ? "psi > pi/2: the ground acceleration falls from the start, a block at rest does not move "
               "then, "
               "and under a rising one it turns to theta < 0, not to theta > 0"
             : "psi > pi/2: the ground acceleration falls from the start, a block at rest does not move then";
}

std::string wrong_side_of_pulse_end(const Root& root) {
  if (root.form == Form::eq86_88 && *root.impact_time >= root.pulse_end)
    return fmt::format("t_i > T_ex: impact at {:.6g}, after the pulse ends at {:.6g}", *root.impact_time,
                       root.pulse_end);
  if (root.form == Form::eq92a_96 && *root.impact_time <= root.pulse_end)
    return fmt::format("t_i < T_ex: impact at {:.6g}, before the pulse ends at {:.6g}", *root.impact_time,
                       root.pulse_end);
  return "";
}

/// The times of the impacts until the end of the pulse, and of the first one after it.
std::vector<Real> impact_times(const Response& response, Real pulse_end) {
  std::vector<Real> times;
  for (const Event& event : response.events) {
    if (event.kind != EventKind::impact) continue;
    times.push_back(event.time);
    if (event.time > pulse_end) break;
  }
  return times;
}

std::string other_motion(const Root& root, const Response& response) {
  if (response.arcs.empty()) return "the block rests: no motion is possible";
  if (response.events.front().kind == EventKind::start && response.arcs.front().start.time > 0 &&
      root.form == Form::eq103)
    return fmt::format(
        "from rest the block stays at rest until {:.6g}: the ground acceleration falls at once",
        static_cast<double>(response.arcs.front().start.time));
  const int first_side = has_impact(root.form) ? -1 : side_of(root.form);
  if (response.arcs.front().side != first_side)
    return fmt::format("theta has the other sign: the motion starts with theta {} 0",
                       first_side > 0 ? "<" : ">");
  const auto times = impact_times(response, root.pulse_end);
  if (!has_impact(root.form))
    return times.empty() || times.front() > root.pulse_end
               ? ""
               : fmt::format("theta changes sign: impact at {:.6g}, before the pulse ends", times.front());
  if (times.empty()) return "the block does not come to an impact";
  if (std::abs(times.front() - *root.impact_time) > same_time * *root.impact_time)
    return fmt::format("the first impact is at {:.6g}, not at {:.6g}", times.front(), *root.impact_time);
  if (times.size() > 1 && times[1] < root.pulse_end)
    return fmt::format("a second impact follows at {:.6g}, before the pulse ends", times[1]);
  return "";
}

/// Whether amplitudes just above, and not those just below, overturn in the form's own way.
std::string not_least(const PulseCase& linear, const Root& root) {
  const int code = side_of(root.form) * (has_impact(root.form) ? 2 : 1);
  const Real step = 1e-9L * root.amplitude;
  const int above = outcome_at(linear, root.amplitude + step).code;
  const int below = root.amplitude - step >= 1 ? outcome_at(linear, root.amplitude - step).code : 0;
  if (above == code && below != code) return "";
  if (below == code) return "not a minimum: it overturns below this amplitude and not above";
  return fmt::format("not a minimum: just above it the outcome is {}",
                     above == 0 ? "safe" : fmt::format("{:+}", above));
}

}  // namespace

std::string why_not(const PulseCase& linear, const Root& root) {
  if (!std::isfinite(root.amplitude) || root.amplitude < 1) return "no amplitude: 1/sin(psi) is not above 1";
  if (std::string reason = wrong_start(linear, root); !reason.empty()) return reason;
  if (std::string reason = wrong_side_of_pulse_end(root); !reason.empty()) return reason;
  ResponseOptions options;
  options.history = true;
  options.until = root.pulse_end + 30;
  const auto motion = pulse_motion(linear.pulse, linear.omega_ratio, root.amplitude, 1);
  const Response response = respond(linear.block, Model::linear, motion, linear.initial, options);
  if (std::string reason = other_motion(root, response); !reason.empty()) return reason;
  return not_least(linear, root);
}

}  // namespace rederive::numeric
