// The nonlinear equations of motion (21a,b), integrated on one side.
#pragma once

#include <numerics/ground_motion.hpp>

#include <gsl/gsl_odeiv2.h>

#include <memory>

namespace rederive::inline numeric {

/// GSL's eighth-order Prince-Dormand method with step control; time is counted from the start of each call,
/// so that very short stretches lose no digits. Throws std::runtime_error if no step keeps the error small
/// enough.
class RockingIntegrator {
 public:
  RockingIntegrator(const Block& block, double tolerance);

  /// The state at `time`, or where |theta| first is pi/2 or more at the end of a step.
  Point integrate(const Piece& piece, int side, const Point& from, Real time);

 private:
  template <auto release>
  struct Release {
    void operator()(auto* object) const { release(object); }
  };
  Block block_;
  std::unique_ptr<gsl_odeiv2_step, Release<gsl_odeiv2_step_free>> step_;
  std::unique_ptr<gsl_odeiv2_control, Release<gsl_odeiv2_control_free>> control_;
  std::unique_ptr<gsl_odeiv2_evolve, Release<gsl_odeiv2_evolve_free>> evolve_;
  double guess_ = 0.1;  ///< the last step size that worked
};

}  // namespace rederive::numeric
