#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <emitted/rocking_block.hpp>
#include <numerics/motion/overturning.hpp>
#include <stdexcept>

namespace rederive::numerics {
namespace {

template <class T>
Margins margins_of(const Block& block, Model model, T angle, T velocity) {
  const bool is_linear = model == Model::linear;
  const T alpha = static_cast<T>(block.alpha);
  const auto critical = [&](T from) {
    return is_linear ? emitted::linear_critical_velocity_positive(from)
                     : emitted::critical_velocity_positive(alpha, from);
  };
  const T square = is_linear ? emitted::linear_impact_velocity_squared_positive(angle, velocity)
                             : emitted::impact_velocity_squared_positive(alpha, angle, velocity);
  const T rebound = static_cast<T>(block.restitution) * std::sqrt(std::max(T(0), square));
  return {velocity - critical(angle), rebound - critical(0)};
}

template <class T>
Outcome outcome(const Block& block, Model model, const FreeMotion<T>& from) {
  Outcome outcome{.impacts = from.impacts, .rests = from.rests, .side = from.side, .lies = from.lies};
  const Margins margins = margins_of(block, model, from.angle, from.velocity);
  outcome.margins = {margins.outward * std::exp(-from.since_launch), margins.returning};
  if (from.lies || margins.outward > 0) {
    outcome.code = from.side * (from.impacts + 1);
  } else if (margins.returning > 0) {
    outcome.impacts = from.impacts + 1;
    outcome.code = -from.side * (outcome.impacts + 1);
  }
  return outcome;
}

}  // namespace

Margins free_motion_margins(const Block& block, Model model, int side, const Point& at) {
  return margins_of(block, model, side * at.angle, side * at.velocity);
}

Outcome outcome_of_free_motion(const Block& block, Model model, const FreeMotion<Real>& from) {
  return outcome(block, model, from);
}

Outcome outcome_of_free_motion(const Block& block, Model model, const FreeMotion<double>& from) {
  return outcome(block, model, from);
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
  if (response.side == 0) return {.rests = response.rests};
  return outcome(block, model,
                 FreeMotion<Real>{.side = response.side,
                                  .angle = response.side * response.end.angle,
                                  .velocity = response.side * response.end.velocity,
                                  .since_launch = response.end.time - response.last_launch,
                                  .impacts = response.impacts,
                                  .rests = response.rests,
                                  .lies = response.lies});
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
