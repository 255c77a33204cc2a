#include <fmt/format.h>
#include <gsl/gsl_errno.h>

#include <algorithm>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <limits>
#include <numbers>
#include <numeric>
#include <numerics/motion/reference.hpp>
#include <stdexcept>
#include <utility>

namespace rederive::numerics {
namespace {

struct Motion {
  double alpha;
  int side;
  double value, slope;  // of the ground acceleration's line, at the start of the call
  double amplitude, omega, phase;
};

/// Equations (21a,b) for theta/alpha, with p = 1.
int right_hand_side(double t, const double state[], double rate[], void* parameters) {
  const Motion& motion = *static_cast<const Motion*>(parameters);
  double ground = motion.value + motion.slope * t;
  if (motion.amplitude != 0)
    ground += emitted::ground_of_sine_pulse(motion.amplitude, motion.omega, motion.phase, t);
  const double theta = motion.alpha * state[0];
  const double force = motion.alpha * ground;
  rate[0] = state[1];
  rate[1] = (motion.side < 0 ? emitted::angular_acceleration_negative(motion.alpha, 1.0, theta, force)
                             : emitted::angular_acceleration_positive(motion.alpha, 1.0, theta, force)) /
            motion.alpha;
  return GSL_SUCCESS;
}

Motion motion_from(const Block& block, const Piece& piece, int side, Real time) {
  const Real since = time - piece.from;
  return {block.alpha,
          side,
          static_cast<double>(piece.value + piece.slope * since),
          static_cast<double>(piece.slope),
          static_cast<double>(piece.amplitude),
          static_cast<double>(piece.omega),
          static_cast<double>(piece.omega * since + piece.phase)};
}

constexpr Real infinity = std::numeric_limits<Real>::infinity();

/// Equations (57), (59); on a straight piece of a record, or on still ground, (62), (63), the same of a line.
Point linear_point(const Arc& arc, Real time) {
  const Piece& piece = arc.piece;
  const Real one = 1, before = arc.start.time - piece.from, since = time - arc.start.time;
  const auto point = [&](const auto& at) { return Point{time, at.value, at.d_t}; };
  const Real angle = arc.start.angle, velocity = arc.start.velocity;
  if (piece.amplitude == 0) {
    const Real ground = piece.value + piece.slope * before;
    if (arc.side < 0)
      return point(emitted::linear_response_on_line_negative_with_derivatives(one, one, ground, piece.slope,
                                                                              angle, velocity, since));
    return point(emitted::linear_response_on_line_positive_with_derivatives(one, one, ground, piece.slope,
                                                                            angle, velocity, since));
  }
  const Real phase = piece.omega * before + piece.phase;
  if (arc.side < 0)
    return point(emitted::linear_response_negative_with_derivatives(one, one, piece.omega, piece.amplitude,
                                                                    phase, angle, velocity, since));
  return point(emitted::linear_response_positive_with_derivatives(one, one, piece.omega, piece.amplitude,
                                                                  phase, angle, velocity, since));
}

/// Returns the first h >= 0 with -y + u h + m h^2 / 2 = 0 for y >= 0, m >= 0: the earliest return to upright.
Real earliest_return(Real y, Real u, Real m) {
  if (m <= 0) return u > 0 ? y / u : infinity;
  const Real root = std::sqrt(u * u + 2 * m * y);
  return u > 0 ? 2 * y / (u + root) : (root - u) / m;
}

}  // namespace

RockingIntegrator::RockingIntegrator(const Block& block, double tolerance)
    : block_(block),
      step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2)),
      control_(gsl_odeiv2_control_y_new(tolerance, tolerance)),
      evolve_(gsl_odeiv2_evolve_alloc(2)) {
  gsl_set_error_handler_off();  // errors are told by status, not by abort
  if (!step_ || !control_ || !evolve_) throw std::bad_alloc();
}

/// Searches by secants, with one end held back where the other does not move (the Illinois rule).
Point RockingIntegrator::turning_point(const gsl_odeiv2_system& system, const Point& from, Real to,
                                       Real velocity) {
  double low = 0, high = static_cast<double>(to - from.time), at_low = static_cast<double>(from.velocity),
         at_high = static_cast<double>(velocity);
  const double start = static_cast<double>(from.time), enough = 1e-9 * high;
  double state[2] = {0, 0}, error[2], time = high;
  while (high - low > enough) {
    const double middle = low + (high - low) * at_low / (at_low - at_high);
    if (!(std::abs(middle - time) > enough * 1e-3)) break;
    time = middle;
    state[0] = static_cast<double>(from.angle), state[1] = static_cast<double>(from.velocity);
    gsl_odeiv2_step_reset(step_.get());
    gsl_odeiv2_step_apply(step_.get(), start, time, state, error, nullptr, nullptr, &system);
    if ((state[1] > 0) == (at_low > 0))
      low = time, at_low = state[1], at_high /= 2;
    else
      high = time, at_high = state[1], at_low /= 2;
  }
  return {from.time + time, state[0], state[1]};
}

Point RockingIntegrator::integrate(const Piece& piece, int side, const Point& from, Real time) {
  Motion motion = motion_from(block_, piece, side, from.time);
  gsl_odeiv2_system system{right_hand_side, nullptr, 2, &motion};
  gsl_odeiv2_evolve_reset(evolve_.get());
  gsl_odeiv2_step_reset(step_.get());
  const double lying = std::numbers::pi / 2 / block_.alpha;
  const double end = static_cast<double>(time - from.time);
  double t = 0, step = std::min(guess_, end);
  double state[2] = {static_cast<double>(from.angle), static_cast<double>(from.velocity)};
  for (int count = 0; t < end; ++count) {
    const double before = t, start[2] = {state[0], state[1]};
    const int status =
        gsl_odeiv2_evolve_apply(evolve_.get(), control_.get(), step_.get(), &system, &t, end, &step, state);
    if (status != GSL_SUCCESS || count > 1'000'000 || !std::isfinite(state[0]))
      throw std::runtime_error(
          fmt::format("the integration stopped at tau = {}", static_cast<double>(from.time) + t));
    if (t - before > guess_ / 4) guess_ = std::max(step, t - before);
    const bool turns = side * start[1] > 0 && side * state[1] < 0;
    const double farthest =
        std::max(side * start[0], side * state[0]) + (std::abs(start[1]) + std::abs(state[1])) * (t - before);
    if (turns && farthest >= lying) {
      const Point turn = turning_point(system, {before, start[0], start[1]}, t, state[1]);
      if (side * turn.angle >= lying) return {from.time + turn.time, turn.angle, 0};
    }
    if (side * state[0] >= lying) return {from.time + t, state[0], state[1]};
  }
  return {time, state[0], state[1]};
}

Mover::Mover(const Block& block, Model model, double tolerance)
    : block_(block),
      model_(model),
      level_(start_level(block, model)),
      resolution_(std::numeric_limits<Real>::epsilon()),
      still_(acceleration(block, model, -1, 0, 0)),
      per_ground_(1),
      per_push_(1),
      advance_([](const Arc& arc, const Point&, Real time) { return linear_point(arc, time); }) {
  if (model == Model::linear) return;
  // Nothing turns the block faster than a ground acceleration at the height above the pivot, theta = -alpha;
  // nothing that pushes it outwards does so less than at upright.
  per_push_ = still_ - acceleration(block, model, -1, 0, 1);
  per_ground_ = acceleration(block, model, -1, -1, -1);
  weight_ = -acceleration(block, model, 1, 1 - std::numbers::pi_v<Real> / (2 * block.alpha), 0);
  resolution_ = std::numeric_limits<double>::epsilon();  // GSL's states are in double
  advance_ = [integrator = std::make_shared<RockingIntegrator>(block, tolerance)](
                 const Arc& arc, const Point& from, Real time) {
    return integrator->integrate(arc.piece, arc.side, from, time);
  };
}

Mover::Mover(Advance advance) : Mover(Block{}, Model::linear) { advance_ = std::move(advance); }

/// Returns a bound of the acceleration towards upright on the arc between two times.
Real Mover::bound(const Arc& arc, Real from, Real to) const {
  const Range range = ground_range(arc.piece, from, to);
  const Real push = arc.side < 0 ? range.low : -range.high;  // > 0: away from upright
  // At the ends of a push it is the level, but for the rounding of ground and time.
  const Piece& piece = arc.piece;
  const Real rounding = 1e-17L * (level_ + piece.amplitude + std::abs(piece.value)) +
                        std::numeric_limits<Real>::epsilon() * std::abs(piece.slope) * to;
  if (push >= level_ - 16 * rounding) return 0;
  return std::max<Real>(0, still_ - (push > 0 ? per_push_ : per_ground_) * push);
}

/// A time, at most `until`, before which the block cannot come back to upright.
///
/// Let y = |theta|/alpha, and y'' >= -m with m >= 0 from now until `to`. Integrated twice,
/// y(t + h) >= y + y' h - m h^2/2: up to the first zero of that parabola, or `to`, y > 0 (earliest_return).
/// Such an m is bound(). By (21) with p = 1, y'' = -sin(alpha (1 - y))/alpha + q cos(alpha (1 - y)), where q
/// is the ground acceleration over alpha g away from upright.
/// - q >= 0, y <= 1: both terms are least at y = 0: y'' >= -still_ + per_push_ q, per_push_ = cos(alpha).
/// - q < 0, y <= 1: the first is least at y = 0, the cosine is at most 1: y'' >= -still_ + per_ground_ q.
/// - y > 1, |theta| <= pi/2: the weight pushes outwards, and y'' >= q if q < 0, else y'' >= 0.
/// In the linear model (56), y'' = -(1 - y) + q, the three factors are 1. Over less time q has a narrower
/// range and m is no larger: `to` is `until` at first, then nearer.
Real Mover::certain_time(const Arc& arc, const Point& at, Real until) const {
  const Real y = arc.side * at.angle, outward = arc.side * at.velocity;
  const auto safe = [&](Real to) {
    return std::min(to, at.time + earliest_return(y, -outward, bound(arc, at.time, to)));
  };
  Real time = safe(until);
  for (const Push& push : pushes_)  // while the ground pushes away from upright
    if (push.side == arc.side && push.from <= at.time && at.time < push.to)
      time = std::max(time, safe(std::min(until, push.to)));
  for (bool longer = true; longer && time < until;) {  // the bound is the lower, the nearer its end
    const Real twice = std::min(until, at.time + 2 * (time - at.time)), here = safe(twice);
    longer = here >= twice && twice > time;
    time = std::max(time, here);
  }
  return time;
}

/// Returns whether the block moves towards upright, and on beyond it, until `to` at half its speed at least.
/// Until theta = alpha, no acceleration away from upright exceeds the one at the start, which falls with
/// |theta|; beyond, none exceeds the one that the weight and the ground cause at the lever R.
bool Mover::falls(const Arc& arc, const Point& at, Real to) const {
  const Range range = ground_range(arc.piece, at.time, to);
  const Real push = std::max<Real>(0, arc.side < 0 ? range.high : -range.low);
  const bool falls_off = model_ == Model::linear || arc.side * at.angle <= 1;
  const Real outward = falls_off
                           ? arc.side * acceleration(block_, model_, arc.side, at.angle, -arc.side * push)
                           : weight_ + per_ground_ * push;
  return outward * (to - at.time) <= -arc.side * at.velocity / 2;
}

/// The impact on a step that falls across upright. Newton's error goes with the square of its last step: one
/// no longer than the root of the resolution is the last. A step that leaves the bracket halves it instead.
Point Mover::impact_between(const Arc& arc, const Point& above, const Point& below) {
  const Real enough = std::sqrt(resolution_) * (below.time - above.time);
  Real low = above.time, high = below.time;
  Point at = below;
  for (bool last = false; !last;) {
    const Real newton = std::clamp(at.time - at.angle / at.velocity, above.time, below.time);
    last = !(std::abs(newton - at.time) > enough);
    const Real next = last || (low < newton && newton < high) ? newton : std::midpoint(low, high);
    if (!last && (next == low || next == high)) break;  // neighbours: nothing is between them
    at = advance_(arc, above, next);
    (arc.side * at.angle > 0 ? low : high) = next;
  }
  at.angle = 0;
  return at;
}

Point Mover::along(const Arc& arc, Real time) { return advance_(arc, arc.start, time); }

Arc Mover::move(const Piece& piece, int side, const Point& start, Real until) {
  Arc arc{.piece = piece, .side = side, .start = start, .end = start};
  if (pushes_from_ != piece.from) pushes_ = pushes(piece, level_), pushes_from_ = piece.from;
  const Real lying = model_ == Model::linear ? infinity : std::numbers::pi_v<Real> / 2 / block_.alpha;
  Point at = start;
  while (at.time < until) {
    const Real certain = certain_time(arc, at, until), twice = std::min(until, 2 * certain - at.time);
    const Real next = falls(arc, at, twice) ? twice : certain;
    if (!(next > at.time)) {  // no room left between the block and upright
      arc.kind = ArcEnd::impact;
      at.angle = 0;
      break;
    }
    const Point there = advance_(arc, at, next);
    if (side * there.angle <= 0 && side * there.velocity < 0) {
      arc.kind = ArcEnd::impact;
      at = impact_between(arc, at, there);
      break;
    }
    at = there;
    if (side * at.angle >= lying) {
      arc.kind = ArcEnd::lies;
      break;
    }
    if (side * at.angle < 0) at.angle = 0;  // rounding, on leaving upright
  }
  arc.end = at;
  if (arc.kind == ArcEnd::impact) arc.rebound = block_.restitution * at.velocity;
  return arc;
}

Follow reference_follower(const Block& block, Model model, const ResponseOptions& options) {
  return [mover = std::make_shared<Mover>(block, model, options.tolerance), keeps = options.history](
             const Piece& piece, int side, const Point& start) {
    Arc arc = mover->move(piece, side, start, piece.to);
    if (keeps) arc.at = [mover, along = arc](Real time) { return mover->along(along, time); };
    return arc;
  };
}

}  // namespace rederive::numerics
