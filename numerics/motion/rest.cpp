#include <algorithm>
#include <cmath>
#include <limits>
#include <numerics/motion/rest.hpp>

namespace rederive::numerics {

AtUpright at_upright(const Block& block, Model model) {
  const Real level = start_level(block, model);
  // The acceleration at upright is linear in the acceleration of the ground, and 0 at start_level.
  return {level, acceleration(block, model, -1, 0, 0) / level,
          4 / std::max<Real>(1 - block.restitution, 1e-4L)};
}

std::optional<Real> time_of_rest(const AtUpright& upright, const Piece& piece, const Point& after_impact) {
  const Real speed = std::abs(after_impact.velocity), begin = after_impact.time;
  // An upper bound, with a factor of two to spare, of how long the chain lasts while the ground is slower
  // than this: each hop takes 2 v/slowing, each e times the one before. Infinite if hops are not short beside
  // it.
  const auto chain_under = [&](Real ground) {
    const Real slowed = upright.slowing * (upright.level - ground);
    return slowed > 4 * speed ? upright.hops * speed / slowed : std::numeric_limits<Real>::infinity();
  };
  const Real first = chain_under(most_ground(piece, begin, begin));
  if (!(begin + first <= piece.to)) return std::nullopt;  // and longer under a stronger ground
  const Real over = std::min(piece.to, begin + 2 * first);
  if (!(begin + chain_under(most_ground(piece, begin, over)) <= over)) return std::nullopt;
  return std::min(over, begin + first / 2);
}

std::optional<Push> push_that_starts(const std::vector<Push>& all, Real level, const Piece& piece,
                                     Real time) {
  for (Push push : all) {
    if (!(time < push.to)) continue;
    push.from = std::max(push.from, time);
    if ((most_ground(piece, push.from, push.to) - level) * (push.to - push.from) >= rest_speed) return push;
  }
  return std::nullopt;
}

}  // namespace rederive::numerics
