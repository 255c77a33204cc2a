// One motion by the kernel, arc after arc, in a single lane of long double or double.
#pragma once

#include <numerics/motion/history.hpp>

namespace rederive::numerics {

/// Returns what follows a block by the kernel, with errors of the size of rounding. Where rounding hides
/// whether a graze is an impact, the second method follows the arc (reference_follower).
Follow kernel_follower(const Block& block, Model model, const ResponseOptions& options);

}  // namespace rederive::numerics
