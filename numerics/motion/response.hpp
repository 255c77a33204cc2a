// The response of the block: arcs joined by impacts, rest and restart.
#pragma once

#include <numerics/motion/arc.hpp>
#include <optional>
#include <string_view>
#include <vector>

namespace rederive::numerics {

/// theta_0/alpha and thetadot_0/(alpha p) at tau = 0; both zero: at rest.
struct InitialState {
  Real angle = 0;
  Real velocity = 0;
};

/// From theta_0 in rad and thetadot_0 in rad/s; less than 1e-15 alpha or alpha p is none. Throws
/// std::invalid_argument unless both are below 1e9 alpha or alpha p and, for the nonlinear model,
/// |theta_0| < pi/2.
InitialState initial_state(const Block& block, Model model, double theta_0, double thetadot_0);

enum class EventKind { start, impact, rest, restart, pulse_end, overturn };
std::string_view name_of(EventKind kind);

/// Velocities are thetadot/(alpha p); they differ at an impact only.
struct Event {
  EventKind kind;
  Real time, angle, velocity_before, velocity_after;
};

/// What happened between tau = 0 and `end.time`.
struct Response {
  Point end;
  int side = 0;               ///< 0: at rest
  bool lies = false;          ///< |theta| reached pi/2
  int impacts = 0;            ///< since the block last left rest
  int rests = 0;              ///< chains of impacts that ended in rest
  Real last_launch = 0;       ///< time of the last start or impact
  std::vector<Event> events;  ///< when wanted
  std::vector<Arc> arcs;      ///< when wanted
};

struct ResponseOptions {
  Real until = -1;       ///< go on after the ground motion until this tau; < 0: stop with the ground motion
  bool history = false;  ///< keep events and arcs
  double tolerance = Mover::default_tolerance;
};

/// Moves the block from `initial` through the ground motion. After an impact the velocity is e times that
/// before, (34), on the other side. Ever smaller impacts end in rest, once what is left of them is too small
/// to matter and over before the ground can start the block again; a resting block starts when |ground| rises
/// above start_level. After 5000 impacts, hops slower than 1e-4 alpha p count as rest even if e = 1. Throws
/// std::runtime_error after 500000 impacts, and a thousand more for each piece of the ground motion.
Response respond(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial,
                 const ResponseOptions& options = {});

/// What decides whether a chain of impacts ends: times p, over alpha.
struct AtUpright {
  Real level;    ///< start_level
  Real slowing;  ///< a block just off upright is slowed down by so much for each unit that the ground lacks
  Real hops;     ///< a chain is so many times as long as half its first hop, at most
};
AtUpright at_upright(const Block& block, Model model);

/// When the chain of ever smaller impacts after this one is over, if it certainly is before the ground can
/// start the block again.
std::optional<Real> time_of_rest(const AtUpright& upright, const Piece& piece, const Point& after_impact);

/// Of `all` pushes of the piece, above `level` = start_level, the one that starts a block at rest at `time`,
/// from when it does; one is too weak that would give it no more speed than that at which a chain of impacts
/// counts as rest.
std::optional<Push> push_that_starts(const std::vector<Push>& all, Real level, const Piece& piece, Real time);

/// The same states at `count` >= 2 times evenly from 0 to `until`, and the ground acceleration in units of
/// alpha g.
struct Sample {
  Real time, angle, velocity, ground;
};
std::vector<Sample> sampled(const Block& block, Model model, const GroundMotion& motion,
                            const Response& response, Real until, int count);

}  // namespace rederive::numerics
