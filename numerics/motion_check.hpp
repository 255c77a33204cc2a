// Does the block really move as a closed form assumes?
#pragma once

#include <numerics/closed_form.hpp>

namespace rederive::inline numeric {

struct Motion {
  bool real;            ///< the block moves as the closed form describes
  std::string why_not;  ///< empty if so, and if it overturns just above the root's amplitude and not below
};

/// Follows the linear motion at the root, with all digits, since a slow pulse magnifies what is left out of
/// the amplitude by e^T_ex.
Motion motion_at(Form form, Pulse pulse, const ExactCase& exact, const ExactRoot& root);

}  // namespace rederive::numeric
