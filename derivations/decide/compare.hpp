// Whether two statements say the same wherever both have values.
#pragma once

#include <derivations/decide/comparison.hpp>

namespace rederive {

struct Sameness {
  std::string by;       ///< "identity" or "sign"
  Fraction factor = 1;  ///< of two equations or inequalities: left = factor * right
  bool has_factor = false;
  Certificate certificate = {};
};

/// Two expressions: the difference is 0. Two relations: the ratio of what is 0, or positive, has no zero and
/// no pole (for inequalities: is positive), or each follows from the other one. A certificate where signs
/// were needed.
std::optional<Sameness> same(Comparison& setting);

/// A divisor of one statement that may be 0 where the other one holds: a condition that would hide a
/// solution. Compared are the irreducible factors of both.
bool hides_a_solution(const Comparison& setting);

}  // namespace rederive
