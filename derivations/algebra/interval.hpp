// Which values can an expression take while its symbols stay in their declared ranges? Exact end points.
#pragma once

#include <derivations/algebra/quadratic.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>

namespace rederive {

/// One end of an interval: an exact constant (rationals, π, roots of them), or infinite. A closed end is
/// attained.
struct End {
  GiNaC::ex value;
  int infinite = 0;  ///< -1 or +1; value is 0 then
  bool closed = false;
};

/// A connected set of real numbers that encloses the values of an expression.
struct Interval {
  End low{0, -1, false}, high{0, +1, false};
};

/// Reads a declared range: "(0, pi/2)", "[0, inf)". Throws std::invalid_argument saying what would be right.
Interval parse_range(std::string_view range);

/// What lies in both; what holds both. Throw std::domain_error where two ends are too close to tell.
Interval overlap(const Interval& a, const Interval& b);
Interval hull(const Interval& a, const Interval& b);

/// Whether a constant is in the range, or at a closed end of it, if these count; no, if it is too close to
/// an end to tell.
bool is_inside(const GiNaC::ex& point, const Interval& range, bool with_ends);

/// An enclosure of the values of `expression` over the declared ranges (not always the tightest one).
Interval interval_of(const GiNaC::ex& expression, const Symbols& symbols);

/// +1 or -1 where the expression provably keeps that sign strictly over all declared ranges, else 0.
int sign_of(const GiNaC::ex& expression, const Symbols& symbols);

/// Whether the expression provably never becomes negative.
bool is_nonnegative(const GiNaC::ex& expression, const Symbols& symbols);

/// A comparison of two constants, with as many digits as are certain: -1, 0, +1. Throws std::domain_error if
/// they are too close to tell.
int compare(const GiNaC::ex& a, const GiNaC::ex& b);

}  // namespace rederive
