#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numerics/motion/kernel_arc.hpp>
#include <numerics/motion/reference.hpp>
#include <numerics/motion/response.hpp>
#include <numerics/motion/rest.hpp>
#include <stdexcept>

namespace rederive::numerics {
namespace {

/// If no history is kept, a chain that is certain to end in time may be cut short at this speed.
constexpr Real soon_at_rest = 1e-3L;
/// The number of impacts after which a motion throws, in all and for each piece of a record.
constexpr long most_impacts = 500'000, most_a_piece = 1'000;

/// Without loss (e = 1) a chain never ends: after `many_impacts`, hops slower than this count as rest, too.
constexpr int many_impacts = 5'000;
constexpr Real slow = 1e-4L;

class Walk {
 public:
  Walk(const AtUpright& upright, Follow follow, const InitialState& initial, bool keeps_history)
      : upright_(upright), follow_(std::move(follow)), keep_(keeps_history) {
    response_.end = {0, initial.angle, initial.velocity};
    const Real leads = initial.angle != 0 ? initial.angle : initial.velocity;
    response_.side = leads > 0 ? 1 : leads < 0 ? -1 : 0;
    if (response_.side != 0) note(EventKind::start, initial.velocity);
  }

  void through(const Piece& piece) {
    allowed_ += most_a_piece;
    while (!response_.lies && response_.end.time < piece.to)
      if (response_.side == 0)
        wait(piece);
      else
        swing(piece);
  }

  void pulse_over() {
    if (!response_.lies) note(EventKind::pulse_end, response_.end.velocity);
  }

  Response result() && { return std::move(response_); }

 private:
  void note(EventKind kind, Real velocity_after) {
    const Point& at = response_.end;
    if (keep_) response_.events.push_back({kind, at.time, at.angle, at.velocity, velocity_after});
  }

  /// At rest until the ground pushes hard enough.
  void wait(const Piece& piece) {
    Point& at = response_.end;
    const std::optional<Push> push =
        push_that_starts(pushes(piece, upright_.level), upright_.level, piece, at.time);
    at = {push ? push->from : piece.to, 0, 0};
    if (!push) return;
    response_.side = push->side;
    response_.impacts = 0;
    response_.last_launch = at.time;
    note(moved_ ? EventKind::restart : EventKind::start, 0);
    moved_ = true;
  }

  void swing(const Piece& piece) {
    moved_ = true;
    const Arc arc = follow_(piece, response_.side, response_.end);
    if (keep_) response_.arcs.push_back(arc);
    response_.end = arc.end;
    response_.lies = arc.kind == ArcEnd::lies;
    instants_ = arc.end.time > arc.start.time ? 0 : instants_ + 1;
    if (arc.kind == ArcEnd::impact) impact(piece, arc.rebound);
    if (instants_ >= 2)
      rest_at(response_.end.time);  // pressed down on either side, by less than time can tell
  }

  void impact(const Piece& piece, Real after) {
    if (++total_ > allowed_)
      throw std::runtime_error(
          fmt::format("more than {} impacts by tau = {}", allowed_, static_cast<double>(response_.end.time)));
    note(EventKind::impact, after);
    ++response_.impacts;
    response_.side = -response_.side;
    response_.end.velocity = after;
    response_.last_launch = response_.end.time;
    const Real small = keep_ ? rest_speed : soon_at_rest;
    if (std::abs(after) < small || (total_ > many_impacts && std::abs(after) < slow)) settle(piece);
  }

  /// Ends a chain of impacts that is over before the ground can start the block again.
  void settle(const Piece& piece) {
    const Point& at = response_.end;
    if (total_ > many_impacts && std::abs(at.velocity) < slow) {
      if (std::abs(ground_at(piece, at.time)) < upright_.level) rest_at(at.time);
    } else if (const std::optional<Real> time = time_of_rest(upright_, piece, at)) {
      rest_at(*time);
    }
  }

  void rest_at(Real time) {
    instants_ = 0;
    if (response_.side == 0) return;
    response_.end = {time, 0, 0};
    response_.side = 0;
    ++response_.rests;
    note(EventKind::rest, 0);
  }

  AtUpright upright_;
  Follow follow_;
  bool keep_, moved_ = false;
  long total_ = 0, allowed_ = most_impacts;
  int instants_ = 0;  ///< hops one after the other that took no time at all
  Response response_;
};

}  // namespace

std::string_view name_of(EventKind kind) {
  switch (kind) {
    case EventKind::start:
      return "start";
    case EventKind::impact:
      return "impact";
    case EventKind::rest:
      return "rest";
    case EventKind::restart:
      return "restart";
    case EventKind::pulse_end:
      return "pulse_end";
    case EventKind::overturn:
      return "overturn";
  }
  return "";
}

InitialState initial_state(const Block& block, Model model, double theta_0, double thetadot_0) {
  if (!std::isfinite(theta_0) || !std::isfinite(thetadot_0))
    throw std::invalid_argument(
        fmt::format("initial conditions {} rad, {} rad/s must be finite", theta_0, thetadot_0));
  if (model == Model::nonlinear && !(std::abs(theta_0) < std::numbers::pi / 2))
    throw std::invalid_argument(fmt::format(
        "theta0 = {} rad must be below pi/2 in size: the block already lies on its side", theta_0));
  constexpr Real nothing = 1e-15L, most = 1e9L;
  const Real alpha = block.alpha, angle = theta_0 / alpha, velocity = thetadot_0 / (alpha * block.p);
  if (std::abs(angle) > most || std::abs(velocity) > most)
    throw std::invalid_argument(fmt::format(
        "initial conditions {} rad, {} rad/s: theta0/alpha and thetadot0/(alpha p) must lie between "
        "-1e9 and 1e9",
        theta_0, thetadot_0));
  return {std::abs(angle) < nothing ? 0 : angle, std::abs(velocity) < nothing ? 0 : velocity};
}

Response respond(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial,
                 const ResponseOptions& options) {
  const auto follower = options.engine == Engine::gsl ? reference_follower : kernel_follower;
  Walk walk(at_upright(block, model), follower(block, model, options), initial, options.history);
  for (const Piece& piece : motion) walk.through(piece);
  walk.pulse_over();
  const Real end = motion.empty() ? 0 : motion.back().to;
  if (options.until > end) {
    Piece still;
    still.from = end;
    still.to = options.until;
    walk.through(still);
  }
  return std::move(walk).result();
}

std::vector<Sample> sampled(const GroundMotion& motion, const Response& response, Real until, int count) {
  std::vector<Sample> samples;
  std::size_t arc = 0, piece = 0;
  for (int i = 0; i < count; ++i) {
    const Real time = std::lerp(Real{0}, until, static_cast<Real>(i) / (count - 1));  // exact at the end
    while (piece < motion.size() && motion[piece].to < time) ++piece;
    const Real ground = piece < motion.size() ? ground_at(motion[piece], time) : 0;
    while (arc < response.arcs.size() && response.arcs[arc].end.time < time) ++arc;
    if (response.lies && arc == response.arcs.size()) break;
    if (arc == response.arcs.size() || response.arcs[arc].start.time > time) {
      samples.push_back({time, 0, 0, ground});
      continue;
    }
    const Point at = response.arcs[arc].at(time);
    samples.push_back({time, at.angle, at.velocity, ground});
  }
  return samples;
}

}  // namespace rederive::numerics
