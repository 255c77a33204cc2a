// The roots of the paper's closed forms for the least amplitude, each proven and checked against the motion.
#pragma once

#include <numerics/search/forms.hpp>
#include <numerics/search/motion_check.hpp>
#include <optional>
#include <vector>

namespace rederive::numerics {

/// One root of a closed form of the linear model, as the nearest doubles and as balls. The amplitude is in
/// units of alpha g, psi in rad, the times are p t.
struct ClosedForm {
  Form form;
  double amplitude, psi;
  std::optional<double> impact_time;  ///< of a form with an impact
  double pulse_end;
  ExactRoot exact;                   ///< contains the root, and is narrow enough for 60 digits and more
  std::optional<Objection> why_not;  ///< why it is not a least amplitude; empty if it is

  /// Whether the block moves as the form says.
  bool real() const { return !why_not || why_not->kind == Objection::Kind::upper_edge; }
  /// Whether it moves so, and overturns just above the amplitude and not below.
  bool admissible() const { return !why_not; }
};

/// Returns every root of the forms that apply to the pulse and the initial conditions, of all or of those in
/// `wanted`, with psi in (0, pi), for (103) in (-pi/2, pi/2), and impact times up to three times the length
/// of the pulse but at most 10 beyond it; 0.01 <= omega_p/p.
///
/// Each root is proven: a continuous function, evaluated in balls, has certain and opposite signs at the ends
/// of a ball. Whether it is admissible is found by following the motion that it describes. The number of bits
/// grows until everything is certain; throws NotCertain if Ball::most_bits are too few.
std::vector<ClosedForm> closed_forms(Pulse pulse, const ExactCase& exact,
                                     const std::vector<Form>& wanted = {});
/// The same for the pulse, block and initial conditions of `asked`, taken as exact.
std::vector<ClosedForm> closed_forms(const PulseCase& asked, const std::vector<Form>& wanted = {});

}  // namespace rederive::numerics
