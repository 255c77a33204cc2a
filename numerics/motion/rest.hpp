// When a chain of ever smaller impacts ends in rest, and which push of the ground starts the block again.
#pragma once

#include <numerics/motion/ground_motion.hpp>
#include <optional>
#include <vector>

namespace rederive::numerics {

/// Where a history is kept, impacts slower than this, in units of alpha p, are at the end of a chain.
inline constexpr Real rest_speed = 1e-9L;

/// What decides whether a chain of impacts ends. Times are multiplied by p, angles divided by alpha.
struct AtUpright {
  Real level;    ///< start_level
  Real slowing;  ///< how fast a block just off upright slows down, for each unit that the ground is below
                 ///< level
  Real hops;     ///< a chain is at most this many times as long as half its first hop
};

/// Returns these values for a block.
AtUpright at_upright(const Block& block, Model model);

/// Returns when the chain of ever smaller impacts after this one is over, or nothing if it is not certain to
/// be over before the ground can start the block again or the piece ends.
std::optional<Real> time_of_rest(const AtUpright& upright, const Piece& piece, const Point& after_impact);

/// Returns the one of `all` pushes of the piece, above `level` = start_level, that starts a block at rest at
/// `time`, from the time at which it does; nothing if none does. A push counts only if it can give the block
/// `rest_speed` or more.
std::optional<Push> push_that_starts(const std::vector<Push>& all, Real level, const Piece& piece, Real time);

}  // namespace rederive::numerics
