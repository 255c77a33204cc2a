// The motion between two events: one side, one smooth stretch of ground acceleration.
#pragma once

#include <numerics/ground_motion.hpp>

#include <memory>

namespace rederive::inline numeric {

/// How an arc ends: at an impact (theta = 0), at the end of the time given, or lying on the side.
enum class ArcEnd { impact, time, lies };

/// One arc: from `start` on `side` (-1: theta<0, +1: theta>0) to `end`.
struct Arc {
  Piece piece;
  int side = -1;
  Point start, end;
  ArcEnd kind = ArcEnd::time;
};

/// Moves the block along arcs: linear by the closed forms (57), (59), (62), (63); nonlinear by integrating
/// (21) with an eighth-order Runge-Kutta method and a step chosen to keep the error below `tolerance`.
class Mover {
 public:
  Mover(const Block& block, Model model, double tolerance = default_tolerance);
  ~Mover();
  Mover(Mover&&) noexcept;

  static constexpr double default_tolerance = 1e-13;

  /// From `start` until the first impact, `until` (inside the piece), or |theta| = pi/2 (nonlinear).
  ///
  /// The first impact cannot be missed: before each step a bound of the acceleration towards the upright
  /// position gives a time in which the block cannot reach it, and the step goes no further. The steps
  /// converge to the impact from below, quadratically, as Newton's iteration does, to the last bit.
  Arc move(const Piece& piece, int side, const Point& start, Real until);

  /// The state at `time` on an arc known not to end before.
  Point along(const Arc& arc, Real time);

 private:
  struct Integrator;
  Point advance(const Arc& arc, const Point& from, Real time);
  Real certain_time(const Arc& arc, const Point& at, Real until) const;
  Real bound(const Arc& arc, Real from, Real to) const;

  Block block_;
  Model model_;
  Real level_;                ///< start_level
  Real still_, per_ground_;   ///< bound of the acceleration towards upright: still + per_ground * (-ground)
  std::vector<Push> pushes_;  ///< of the piece that starts at pushes_from_
  Real pushes_from_ = -1;
  std::unique_ptr<Integrator> integrator_;
};

}  // namespace rederive::numeric
