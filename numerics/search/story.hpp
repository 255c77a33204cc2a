// The whole story of one pulse or record: outcome, events and history.
#pragma once

#include <numerics/motion/overturning.hpp>
#include <optional>

namespace rederive::numerics {

/// A motion and its outcome.
struct Story {
  Outcome outcome;
  std::optional<Real> overturn_time;  ///< last passage of |theta| = alpha outward
  Response response;                  ///< events until `until`
  Real until = 0;
};

/// Returns the ground motion of a pulse of this amplitude, in units of alpha g: none if the amplitude is 0 or
/// too weak to move a block at rest.
/// Throws std::invalid_argument for values out of range.
GroundMotion pulse_or_none(const PulseCase& asked, double amplitude);

/// Returns the story of the block until tau = `until`; if that is negative, until 1 after it overturns, or
/// until it comes to rest after the ground motion, or 10 after the ground motion.
Story tell(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial,
           Real until = -1);

/// Returns the number of impacts until the block overturns, or of all if it does not.
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
