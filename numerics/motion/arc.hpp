// The motion between two events, and what follows it.
#pragma once

#include <functional>
#include <numerics/motion/ground_motion.hpp>

namespace rederive::numerics {

/// How an arc ends: at an impact (theta = 0), at the end of the time given, or lying on the side
/// (|theta| = pi/2).
enum class ArcEnd { impact, time, lies };

/// The motion between two events, on one side (-1: theta < 0, +1: theta > 0) and one smooth piece of ground
/// motion.
struct Arc {
  Piece piece;
  int side = -1;
  Point start, end;  ///< `end` has the velocity before an impact
  ArcEnd kind = ArcEnd::time;
  Real rebound = 0;  ///< the velocity after the impact, (34), with which the block moves to the other side

  /// The state at a time from start.time to end.time. Empty if no history is kept.
  std::function<Point(Real time)> at = {};
};

/// The error of a step of GSL's integrator, in units of alpha and alpha p, unless another is asked for.
inline constexpr double default_tolerance = 1e-12;

/// What follows a motion. taylor: the kernel, by Taylor series. gsl: the independent second method, GSL's
/// integrator for the nonlinear model and closed forms for the linear one.
enum class Engine { gsl, taylor };

struct ResponseOptions {
  Real until = -1;       ///< go on after the ground motion until this tau; < 0: stop with the ground motion
  bool history = false;  ///< keep events and arcs
  Engine engine = Engine::taylor;
  bool in_double = false;  ///< the kernel computes in double instead of long double, which is faster
  double tolerance = default_tolerance;  ///< of GSL's integrator; the kernel follows one motion to all digits
};

/// Moves the block from `start`, on `side`, through the piece: until the first impact, until the end of the
/// piece, or until it lies.
using Follow = std::function<Arc(const Piece& piece, int side, const Point& start)>;

}  // namespace rederive::numerics
