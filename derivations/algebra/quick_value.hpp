// Values in double precision, for looking around before anything is decided.
#pragma once

#include <derivations/algebra/evaluate.hpp>
#include <optional>

namespace rederive {

/// The value of the tree at the point, a hundred times as fast as evaluate(), where an estimate of what
/// rounding costs leaves no doubt of its sign. Nothing elsewhere: near 0, far out, and where there is no
/// value. An estimate, not a bound: nothing is decided by it.
std::optional<double> quick_value(const Tree& tree, const Point& point);

}  // namespace rederive
