// The second method: the motion between two events by closed forms (linear) or by GSL's integrator
// (nonlinear). It is independent of the kernel.
#pragma once

#include <functional>
#include <numerics/motion/history.hpp>
#include <vector>

namespace rederive::numerics {

/// Moves the block along arcs: linear by the closed forms (57), (59), (62), (63); nonlinear by integrating
/// (21) with an eighth-order Runge-Kutta method and a step chosen to keep the error below `tolerance`.
class Mover {
 public:
  Mover(const Block& block, Model model, double tolerance = default_tolerance);

  /// Returns the state at a time on the arc that went through a point before.
  using Advance = std::function<Point(const Arc& arc, const Point& from, Real time)>;
  /// A linear motion that the caller computes with more digits than Real has.
  explicit Mover(Advance advance);

  /// Returns the arc from `start` until the first impact, `until` (inside the piece), or |theta| = pi/2
  /// (nonlinear).
  ///
  /// The first impact cannot be missed. A bound of the acceleration towards upright gives a time in which the
  /// block cannot come back, and a step goes no further; until, by a bound of the acceleration away from
  /// upright, it is certain to fall all along a step twice as long. That step is taken, and if it crosses
  /// upright, the impact is found on it by Newton's iteration in a bracket, to the last bit.
  Arc move(const Piece& piece, int side, const Point& start, Real until);

  /// Returns the state at `time` on an arc that does not end before.
  Point along(const Arc& arc, Real time);

 private:
  Real certain_time(const Arc& arc, const Point& at, Real until) const;
  bool falls(const Arc& arc, const Point& at, Real to) const;
  Point impact_between(const Arc& arc, const Point& above, const Point& below);
  Real bound(const Arc& arc, Real from, Real to) const;

  Block block_;
  Model model_;
  Real level_;                ///< start_level
  Real resolution_;           ///< of the time of an impact, in units of the step that crosses
  Real still_;                ///< acceleration towards upright of a block just off it, on ground that rests
  Real per_ground_;           ///< at most what a ground acceleration towards upright adds to it
  Real per_push_;             ///< at least what one away from upright takes from it
  Real weight_ = 0;           ///< nonlinear: no acceleration by the weight exceeds this, at any angle
  std::vector<Push> pushes_;  ///< of the piece that starts at pushes_from_
  Real pushes_from_ = -1;
  Advance advance_;
};

/// Returns what follows a block by a Mover.
Follow reference_follower(const Block& block, Model model, const ResponseOptions& options);

}  // namespace rederive::numerics
