// The whole story of one pulse or record: outcome, events and history.
#pragma once

#include <numerics/motion/overturning.hpp>
#include <optional>

namespace rederive::numerics {

struct Story {
  Outcome outcome;
  std::optional<Real> overturn_time;  ///< last passage of |theta| = alpha outward
  Response response;                  ///< events until `until`
  Real until = 0;
};

/// The ground motion of a pulse of this amplitude: none if it is too weak to move a block at rest, or 0.
/// Throws std::invalid_argument for values out of range.
GroundMotion pulse_or_none(const PulseCase& asked, double amplitude);

/// Follows the block until tau = `until`; if negative, until shortly after it overturns, or comes to rest, or
/// ten units of p t after the ground.
Story tell(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial,
           Real until = -1);

/// Impacts until it overturns, or all that there were.
int impacts_of(const Story& story);

/// The friction that the motion needs at the pivot: the largest |H|/V, from the reactions of the corrected
/// (47).
struct Friction {
  double required = 0;     ///< infinite if V <= 0 somewhere
  double time = 0;         ///< when
  bool uplift = false;     ///< V <= 0 somewhere: the block would leave the ground
  double uplift_time = 0;  ///< when first found
};
Friction required_friction(const Block& block, const Story& story);

}  // namespace rederive::numerics
