// Does the block really move as a closed form assumes?
#pragma once

#include <numerics/closed_form.hpp>

namespace rederive {

/// Follows the linear motion at the root's amplitude. Empty if it is the motion that the closed form
/// describes and its amplitude is the least of a window; otherwise says what happens instead.
std::string why_not(const PulseCase& linear, const ClosedForm& root);

}  // namespace rederive
