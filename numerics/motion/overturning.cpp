#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <emitted/rocking_block.hpp>
#include <numerics/motion/overturning.hpp>
#include <stdexcept>

namespace rederive::numerics {
namespace {

/// What free motion on one side comes to: the velocity with which it just reaches theta = alpha from here,
/// and the square of that with which it comes to upright. (68), (75) and the invariant of (62), or the
/// energies (22).
struct FreeMotion {
  Real critical, impact_squared;
};

FreeMotion free_motion(const Block& block, Model model, int side, const Point& at) {
  const Real alpha = block.alpha;
  if (model == Model::linear)
    return side < 0 ? FreeMotion{emitted::linear_critical_velocity_negative(at.angle),
                                 emitted::linear_impact_velocity_squared_negative(at.angle, at.velocity)}
                    : FreeMotion{emitted::linear_critical_velocity_positive(at.angle),
                                 emitted::linear_impact_velocity_squared_positive(at.angle, at.velocity)};
  return side < 0 ? FreeMotion{emitted::critical_velocity_negative(alpha, at.angle),
                               emitted::impact_velocity_squared_negative(alpha, at.angle, at.velocity)}
                  : FreeMotion{emitted::critical_velocity_positive(alpha, at.angle),
                               emitted::impact_velocity_squared_positive(alpha, at.angle, at.velocity)};
}

}  // namespace

Margins free_motion_margins(const Block& block, Model model, int side, const Point& at) {
  const FreeMotion here = free_motion(block, model, side, at);
  const Real launch = side * free_motion(block, model, -side, {}).critical;  // negative: to the other side
  const Real impact = std::sqrt(std::max<Real>(0, here.impact_squared));
  return {side * (at.velocity - here.critical), block.restitution * impact + launch};
}

std::string words_for(int code, SideNames names) {
  if (code == 0) return "safe";
  const auto impacts = static_cast<std::size_t>(std::abs(code) - 1);
  const auto& sides = names == SideNames::signs ? words_of_sides : words_of_directions;
  const std::string how =
      fmt::format(fmt::runtime(words_of_impacts[std::min<std::size_t>(impacts, 2)]), impacts);
  return fmt::format(fmt::runtime(words_of_overturning), sides[code < 0 ? 0 : 1], how);
}

std::string_view outcome_name(int code) { return code == 0 ? "safe" : "overturned"; }

Outcome outcome_at_end(const Block& block, Model model, const Response& response) {
  Outcome outcome;
  outcome.rests = response.rests;
  if (response.side == 0) return outcome;
  outcome.impacts = response.impacts;
  outcome.side = response.side;
  outcome.lies = response.lies;
  Margins margins = free_motion_margins(block, model, response.side, response.end);
  if (response.lies || margins.outward > 0) {
    outcome.code = response.side * (response.impacts + 1);
  } else if (margins.returning > 0) {
    outcome.impacts = response.impacts + 1;
    outcome.code = -response.side * (outcome.impacts + 1);
  }
  margins.outward *= std::exp(response.last_launch - response.end.time);
  outcome.margins = margins;
  return outcome;
}

Outcome outcome_of(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial) {
  return outcome_at_end(block, model, respond(block, model, motion, initial));
}

Outcome outcome_at(const PulseCase& asked, Real amplitude) {
  const Real level = start_level(asked.block, asked.model);
  const bool rests = asked.initial.angle == 0 && asked.initial.velocity == 0;
  if (rests && amplitude < level && amplitude >= 0) return {};
  const GroundMotion motion = pulse_motion(asked.pulse, asked.omega_ratio, amplitude, level);
  const ResponseOptions options{.engine = Engine::gsl, .tolerance = asked.tolerance};
  return outcome_at_end(asked.block, asked.model,
                        respond(asked.block, asked.model, motion, asked.initial, options));
}

}  // namespace rederive::numerics
