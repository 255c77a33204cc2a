// Does the block really move as a closed form assumes?
#pragma once

#include <numerics/closed_form.hpp>

namespace rederive::inline numeric {

/// A root before it is rounded: slow pulses magnify the rounding of the amplitude by e^T_ex.
struct Root {
  Form form;
  Real amplitude, psi;
  std::optional<Real> impact_time;
  Real pulse_end;
};

/// Follows the linear motion at the root's amplitude. Empty if it is the motion that the closed form
/// describes and its amplitude is the least of a window; otherwise says what happens instead.
std::string why_not(const PulseCase& linear, const Root& root);

}  // namespace rederive::numeric
