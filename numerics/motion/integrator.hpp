// The nonlinear equations of motion (21a,b), integrated on one side.
#pragma once

#include <gsl/gsl_odeiv2.h>

#include <memory>
#include <numerics/motion/ground_motion.hpp>

namespace rederive::numerics {

/// Integrates by GSL's eighth-order Prince-Dormand method with step control (Hairer, Norsett, Wanner, Solving
/// Ordinary Differential Equations I, 2nd ed. 1993, sections II.4-II.6). Each call counts time from its
/// start, so that very short stretches lose no digits.
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
  /// Where the velocity vanishes between `from` and the time `to`, at which it is `velocity`.
  Point turning_point(const gsl_odeiv2_system& system, const Point& from, Real to, Real velocity);

  Block block_;
  std::unique_ptr<gsl_odeiv2_step, Release<gsl_odeiv2_step_free>> step_;
  std::unique_ptr<gsl_odeiv2_control, Release<gsl_odeiv2_control_free>> control_;
  std::unique_ptr<gsl_odeiv2_evolve, Release<gsl_odeiv2_evolve_free>> evolve_;
  double guess_ = 0.1;  ///< the last step size that worked
};

}  // namespace rederive::numerics
