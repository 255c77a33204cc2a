#include <numerics/story.hpp>

#include <emitted/rocking_block.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace rederive::inline numeric {
namespace {

constexpr Real long_enough = 60;  ///< e^60 times any margin above zero has left |theta| = alpha behind
constexpr Real a_while = 10;

/// The last passage of |theta| = alpha outward on the side to which the block overturns.
Event overturn_event(Mover& mover, const Response& response, int side) {
  const Arc* last = &response.arcs.back();
  for (const Arc& arc : response.arcs)
    if (arc.side == side && side * arc.start.angle < 1 && side * arc.end.angle >= 1) last = &arc;
  Real low = last->start.time, high = side * last->start.angle >= 1 ? low : last->end.time;
  for (Real middle = std::midpoint(low, high); low < middle && middle < high;
       middle = std::midpoint(low, high))
    (side * mover.along(*last, middle).angle < 1 ? low : high) = middle;
  const Point at = mover.along(*last, high);
  return {EventKind::overturn, high, at.angle, at.velocity, at.velocity};
}

Real end_of(const GroundMotion& motion) { return motion.empty() ? 0 : motion.back().to; }

Real default_end(const Story& story, const GroundMotion& motion) {
  if (story.overturn_time) return *story.overturn_time + 1;
  for (const Event& event : story.response.events)
    if (event.kind == EventKind::rest && event.time >= end_of(motion)) return event.time;
  return end_of(motion) + a_while;
}

/// |H|/V at a point of an arc, and V, both in units of m g where they are forces.
struct Reactions {
  Real horizontal, vertical;
};

Reactions reactions(const Block& block, const Arc& arc, const Point& at) {
  const Real alpha = block.alpha, one = 1;
  const Real theta = alpha * at.angle, thetadot = alpha * at.velocity,
             ground = alpha * ground_at(arc.piece, at.time);
  if (arc.side < 0)
    return {emitted::horizontal_reaction_negative(alpha, theta, thetadot, ground, one),
            emitted::vertical_reaction_negative(alpha, theta, thetadot, ground, one)};
  return {emitted::horizontal_reaction_positive(alpha, theta, thetadot, ground, one),
          emitted::vertical_reaction_positive(alpha, theta, thetadot, ground, one)};
}

/// The largest ratio on one arc: the best of a few points, refined between its neighbours by golden sections.
void friction_on(const Block& block, Mover& mover, const Arc& arc, Real until, Friction& friction) {
  const Real end = std::min(arc.end.time, until);
  const int count = std::clamp(static_cast<int>((end - arc.start.time) / 0.02L), 2, 64);
  const auto ratio = [&](Real time) {
    const Reactions force = reactions(block, arc, mover.along(arc, time));
    if (force.vertical <= 0 && !friction.uplift)
      friction.uplift = true, friction.uplift_time = static_cast<double>(time);
    return force.vertical > 0 ? std::abs(force.horizontal) / force.vertical
                              : std::numeric_limits<Real>::infinity();
  };
  Real best = arc.start.time, most = ratio(best);
  for (int i = 1; i <= count; ++i) {
    const Real time = std::lerp(arc.start.time, end, static_cast<Real>(i) / count), value = ratio(time);
    if (value > most) best = time, most = value;
  }
  if (most < 0.9L * friction.required) return;
  const Real step = (end - arc.start.time) / count;
  Real low = std::max(arc.start.time, best - step), high = std::min(end, best + step);
  for (int i = 0; i < 60 && std::isfinite(most); ++i) {
    const Real left = std::lerp(low, high, 0.382L), right = std::lerp(low, high, 0.618L);
    const Real at_left = ratio(left), at_right = ratio(right);
    most = std::max({most, at_left, at_right});
    (at_left > at_right ? high : low) = at_left > at_right ? right : left;
  }
  if (most > friction.required) {
    friction.required = static_cast<double>(most);
    friction.time = static_cast<double>(std::midpoint(low, high));
  }
}

}  // namespace

Story tell(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial,
           Real until, double tolerance) {
  Story story;
  story.outcome = outcome_of(block, model, motion, initial, tolerance);
  ResponseOptions options;
  options.history = true;
  options.tolerance = tolerance;
  const bool over = story.outcome.code != 0;
  options.until = std::max(until, end_of(motion) + (over ? long_enough : until < 0 ? a_while : 0));
  story.response = respond(block, model, motion, initial, options);
  auto& events = story.response.events;
  if (over) {
    Mover mover(block, model, tolerance);
    events.push_back(overturn_event(mover, story.response, story.outcome.code > 0 ? 1 : -1));
    story.overturn_time = events.back().time;
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.time < b.time; });
  story.until = until < 0 ? default_end(story, motion) : until;
  std::erase_if(events, [&](const Event& event) { return event.time > story.until; });
  return story;
}

Friction required_friction(const Block& block, Model model, const Story& story) {
  Friction friction;
  Mover mover(block, model);
  for (const Arc& arc : story.response.arcs)
    if (arc.start.time < story.until) friction_on(block, mover, arc, story.until, friction);
  return friction;
}

}  // namespace rederive::numeric
