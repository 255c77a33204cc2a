#include <algorithm>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <limits>
#include <numerics/search/roots.hpp>
#include <numerics/search/story.hpp>

namespace rederive::numerics {
namespace {

constexpr Real long_enough = 60;  ///< e^60 times any margin above zero has left |theta| = alpha behind
constexpr Real a_while = 10;

/// Returns the last passage of |theta| = alpha outwards on the side to which the block overturns; the start,
/// if the motion began beyond and stayed there.
Event overturn_event(const Response& response, int side) {
  Point at = response.arcs.front().start;
  for (auto arc = response.arcs.rbegin(); arc != response.arcs.rend(); ++arc) {
    if (arc->side != side || side * arc->end.angle < 1) continue;
    const auto beyond = [&](double time) { return static_cast<double>(side * arc->at(time).angle - 1); };
    const double start = static_cast<double>(arc->start.time), end = static_cast<double>(arc->end.time);
    const int points = std::clamp(static_cast<int>((end - start) / 0.005), 4, 512);
    const auto passages = sign_changes(beyond, start, end, points);
    if (passages.empty()) continue;
    at = arc->at(passages.back().outside);
    break;
  }
  return {EventKind::overturn, at.time, at.angle, at.velocity, at.velocity};
}

Real end_of(const GroundMotion& motion) { return motion.empty() ? 0 : motion.back().to; }

Real default_end(const Story& story, const GroundMotion& motion) {
  if (story.overturn_time) return *story.overturn_time + 1;
  for (const Event& event : story.response.events)
    if (event.kind == EventKind::rest && event.time >= end_of(motion)) return event.time;
  return end_of(motion) + a_while;
}

/// The reactions at a point of an arc, in units of m g where they are forces.
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

/// Updates the largest ratio |H|/V by one arc: takes the best of a few points, and the greatest value near
/// it.
void friction_on(const Block& block, const Arc& arc, Real until, Friction& friction) {
  const double start = static_cast<double>(arc.start.time),
               end = static_cast<double>(std::min(arc.end.time, until));
  const int count = std::clamp(static_cast<int>((end - start) / 0.02), 2, 64);
  double best = start, most = 0;
  const auto ratio = [&](double time) {
    const Reactions force = reactions(block, arc, arc.at(time));
    if (force.vertical <= 0 && !friction.uplift) friction.uplift = true, friction.uplift_time = time;
    const double value = force.vertical > 0 ? static_cast<double>(std::abs(force.horizontal) / force.vertical)
                                            : std::numeric_limits<double>::infinity();
    if (value > most) best = time, most = value;
    return value;
  };
  for (int i = 0; i <= count; ++i) ratio(std::lerp(start, end, static_cast<double>(i) / count));
  if (most < 0.9 * friction.required) return;
  const double step = (end - start) / count, low = std::max(start, best - step),
               high = std::min(end, best + step);
  if (std::isfinite(most)) least_between([&](double time) { return -ratio(time); }, low, high);
  if (most > friction.required) friction.required = most, friction.time = best;
}

}  // namespace

GroundMotion pulse_or_none(const PulseCase& asked, double amplitude) {
  const Real level = start_level(asked.block, asked.model);
  const bool rests = asked.initial.angle == 0 && asked.initial.velocity == 0;
  if ((amplitude < level && rests) || amplitude == 0) return {};
  return pulse_motion(asked.pulse, asked.omega_ratio, amplitude, level);
}

Story tell(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial,
           Real until) {
  Story story;
  story.outcome = outcome_of(block, model, motion, initial);
  ResponseOptions options;
  options.history = true;
  const bool over = story.outcome.code != 0;
  options.until = std::max(until, end_of(motion) + (over ? long_enough : until < 0 ? a_while : 0));
  story.response = respond(block, model, motion, initial, options);
  auto& events = story.response.events;
  if (over) {
    events.push_back(overturn_event(story.response, story.outcome.code > 0 ? 1 : -1));
    story.overturn_time = events.back().time;
  }
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.time < b.time; });
  story.until = until < 0 ? default_end(story, motion) : until;
  std::erase_if(events, [&](const Event& event) { return event.time > story.until; });
  return story;
}

int impacts_of(const Story& story) {
  if (story.outcome.code != 0) return story.outcome.impacts;
  const auto is_impact = [](const Event& event) { return event.kind == EventKind::impact; };
  return static_cast<int>(std::ranges::count_if(story.response.events, is_impact));
}

Friction required_friction(const Block& block, const Story& story) {
  Friction friction;
  for (const Arc& arc : story.response.arcs)
    if (arc.start.time < story.until) friction_on(block, arc, story.until, friction);
  return friction;
}

}  // namespace rederive::numerics
