// The paper's closed forms for the least amplitude: every root, and whether the block really moves so.
#pragma once

#include <numerics/digits.hpp>
#include <numerics/overturning.hpp>

#include <optional>
#include <string>
#include <vector>

namespace rederive::inline numeric {

/// (71), (78): without impact from rest; (86)&(88): one impact before the pulse ends; (92a)&(96): one after;
/// (103): cosine pulse to theta>0; (104): sine pulse to theta<0, both with initial conditions.
enum class Form { eq71, eq78, eq86_88, eq92a_96, eq103, eq104 };

/// One root of a closed form of the linear model. amplitude = 1/sin(psi), for (103) 1/cos(psi); times are p
/// t.
struct ClosedForm {
  Form form;
  double amplitude, psi;
  std::optional<double> impact_time;
  double pulse_end;
  bool admissible;
  std::string why_not;  ///< empty if admissible

  std::vector<std::string> equations() const;
};

/// Every root of the forms that apply to the pulse and the initial conditions, psi in (0, pi), for (103) in
/// (-pi/2, pi/2). Whether a root is admissible is found by following the linear motion at that amplitude.
std::vector<ClosedForm> closed_forms(const PulseCase& asked);

/// The numbers that a closed form depends on, with all their digits.
struct ExactCase {
  Digits omega_ratio, restitution, push;  ///< push = (theta_0 + thetadot_0/p)/alpha
};

/// The root by Newton's iteration on the emitted residual and its emitted derivatives, until nothing changes
/// within `digits` and ten more. Throws std::runtime_error if the working digits do not allow that.
struct ExactRoot {
  Digits amplitude, psi, impact_time, pulse_end;
};
ExactRoot exact_root(const ClosedForm& root, const ExactCase& exact, int digits);

}  // namespace rederive::numeric
