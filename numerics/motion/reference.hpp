// The second method, which is independent of the kernel: the motion between two events by closed forms
// (linear) or by GSL's integrator (nonlinear).
#pragma once

#include <gsl/gsl_odeiv2.h>

#include <functional>
#include <memory>
#include <numerics/motion/arc.hpp>
#include <vector>

namespace rederive::numerics {

/// Integrates the nonlinear equations of motion (21a,b) on one side by GSL's eighth-order Prince-Dormand
/// method with step control (Hairer, Norsett, Wanner, Solving Ordinary Differential Equations I, 2nd ed.
/// 1993, sections II.4-II.6). Each call counts time from its start, so that very short stretches lose no
/// digits.
class RockingIntegrator {
 public:
  RockingIntegrator(const Block& block, double tolerance);

  /// Returns the state at `time`. If |theta| reaches pi/2 before, returns the state where that is found: at
  /// the end of a step or, if the block turns back inside it, at the turning point. Throws std::runtime_error
  /// if no step keeps the error small enough.
  Point integrate(const Piece& piece, int side, const Point& from, Real time);

 private:
  template <auto release>
  struct Release {
    void operator()(auto* object) const { release(object); }
  };
  /// Returns the point at which the velocity vanishes between `from` and the time `to`, at which it is
  /// `velocity`.
  Point turning_point(const gsl_odeiv2_system& system, const Point& from, Real to, Real velocity);

  Block block_;
  std::unique_ptr<gsl_odeiv2_step, Release<gsl_odeiv2_step_free>> step_;
  std::unique_ptr<gsl_odeiv2_control, Release<gsl_odeiv2_control_free>> control_;
  std::unique_ptr<gsl_odeiv2_evolve, Release<gsl_odeiv2_evolve_free>> evolve_;
  double guess_ = 0.1;  ///< the last step size that worked
};

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
