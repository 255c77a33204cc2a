// The response of the block: arcs joined by impacts, rest and restart.
#pragma once

#include <numerics/motion/arc.hpp>
#include <string_view>
#include <vector>

namespace rederive::numerics {

/// The state of the block at tau = 0: theta_0/alpha and thetadot_0/(alpha p); both are zero at rest.
struct InitialState {
  Real angle = 0;
  Real velocity = 0;
};

/// Returns the initial state for theta_0 in rad and thetadot_0 in rad/s; values below 1e-15 alpha or alpha p
/// count as zero. Throws std::invalid_argument unless both are below 1e9 alpha or alpha p and, in the
/// nonlinear model, |theta_0| < pi/2.
InitialState initial_state(const Block& block, Model model, double theta_0, double thetadot_0);

enum class EventKind { start, impact, rest, restart, pulse_end, overturn };

/// Returns the name of an event: "pulse_end".
std::string_view name_of(EventKind kind);

/// An event at `time` (tau), at theta/alpha = `angle`. The velocities thetadot/(alpha p) before and after it
/// differ at an impact only.
struct Event {
  EventKind kind;
  Real time, angle, velocity_before, velocity_after;
};

/// The motion between tau = 0 and `end.time`.
struct Response {
  Point end;
  int side = 0;               ///< 0: at rest
  bool lies = false;          ///< |theta| reached pi/2
  int impacts = 0;            ///< since the block last left rest
  int rests = 0;              ///< chains of impacts that ended in rest
  Real last_launch = 0;       ///< time of the last start or impact
  std::vector<Event> events;  ///< if a history is kept
  std::vector<Arc> arcs;      ///< if a history is kept
};

/// Returns the response of the block, from `initial`, to the ground motion. After an impact the velocity is e
/// times the velocity before it, (34), on the other side. Ever smaller impacts end in rest as soon as the
/// rest of the chain is too small to matter and over before the ground can start the block again; a resting
/// block starts when |ground| rises above start_level. After 5000 impacts, hops slower than 1e-4 alpha p
/// count as rest even if e = 1. Throws std::runtime_error after 500000 impacts, and a thousand more for each
/// piece of the ground motion.
Response respond(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial,
                 const ResponseOptions& options = {});

/// A state of the block, and the ground acceleration in units of alpha g.
struct Sample {
  Real time, angle, velocity, ground;
};

/// Returns the states of a response, which has a history, at `count` >= 2 times evenly from 0 to `until`;
/// fewer if the block lies before.
std::vector<Sample> sampled(const GroundMotion& motion, const Response& response, Real until, int count);

}  // namespace rederive::numerics
