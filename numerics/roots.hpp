// Roots of a function of one number.
#pragma once

#include <numerics/block.hpp>

#include <functional>
#include <vector>

namespace rederive::inline numeric {

using Function = std::function<Real(Real)>;

/// Two neighbouring numbers with the root between them.
struct Bracket {
  Real low, high;
};

/// The roots between `low` and `high`, in order, bisected to the last bit: sign changes between `count`
/// points, and dips of |f| that pass through zero in between.
std::vector<Bracket> roots_between(const Function& f, Real low, Real high, int count);

}  // namespace rederive::numeric
