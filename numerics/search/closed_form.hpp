// The paper's closed forms for the least amplitude: every root, proven, and whether the block really moves
// so.
#pragma once

#include <emitted/rocking_block.hpp>
#include <numerics/motion/overturning.hpp>
#include <numerics/search/ball_functions.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace rederive::numerics {

/// (71), (78): without impact from rest; (86)&(88): one impact before the pulse ends; (92a)&(96): one after;
/// (103): cosine pulse to theta>0; (104): sine pulse to theta<0, both with initial conditions.
enum class Form { eq71, eq78, eq86_88, eq92a_96, eq103, eq104 };

/// The outcome that begins or ends at a root: side*(impacts+1).
int code_of(Form form);

/// What the closed forms of the linear model depend on, with all its digits: omega_p/p, e, theta_0/alpha and
/// thetadot_0/(alpha p).
struct ExactCase {
  Ball omega_ratio, restitution, angle, velocity;
};
ExactCase exact_case_of(const PulseCase& asked);

/// amplitude = 1/sin(psi), for (103) 1/cos(psi); times are p t; impact_time is 0 for a form without impact.
struct ExactRoot {
  Ball amplitude, psi, impact_time, pulse_end;
};

/// More bits are needed.
struct NotCertain : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One root of a closed form of the linear model, to the nearest double and in balls.
struct ClosedForm {
  Form form;
  double amplitude, psi;
  std::optional<double> impact_time;
  double pulse_end;
  ExactRoot exact;      ///< holds the root, and is narrow enough for 60 digits and more
  bool real;            ///< the block moves so
  bool admissible;      ///< and overturns just above the amplitude and not below
  std::string why_not;  ///< empty if admissible

  std::vector<std::string> equations() const;
};

/// Every root of the forms, all or those wanted, that apply to the pulse and the initial conditions, psi in
/// (0, pi), for (103) in (-pi/2, pi/2), impact times up to three times the pulse but at most 10 beyond it;
/// 0.01 <= omega_p/p.
/// Each is proven: a continuous function, evaluated in balls, has certain and opposite signs at the ends of a
/// ball. Whether a root is admissible is found by following the motion that it stands for. The bits of the
/// balls are raised until all is certain; throws NotCertain if Ball::most_bits are not enough.
std::vector<ClosedForm> closed_forms(Pulse pulse, const ExactCase& exact,
                                     const std::vector<Form>& wanted = {});
std::vector<ClosedForm> closed_forms(const PulseCase& asked, const std::vector<Form>& wanted = {});

/// Why the block does not move as the form at this root says; empty if it does. The linear motion is followed
/// in balls.
std::string contradiction(Form form, Pulse pulse, const ExactCase& exact, const ExactRoot& root);

}  // namespace rederive::numerics

namespace rederive::emitted {
template <>
inline Ball pi<Ball>() {
  return Ball::pi();
}
}  // namespace rederive::emitted
