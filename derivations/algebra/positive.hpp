// Polynomials in one variable that are positive on an interval, so written that it shows.
#pragma once

#include <derivations/algebra/interval.hpp>
#include <optional>

namespace rederive {

/// A polynomial in `x` with rational coefficients (in x/sqrt(n) for a small n, and but for a number), of
/// which the range shows that it is positive (or not negative) while x keeps to the range: squares of
/// factors, times
///   on [a, inf)    sum of c_k s^k/(1 + s)^n, with s = x - a and no negative c_k (Polya);
///   on [a, b]      d + sum of c_k s^k r^(n-k), with s = x - a and r = b - x (Bernstein);
///   everywhere     (p^2 + D)/(2 E), with p = E(x^2) + x O(x^2) and D = E^2 - x^2 O^2, both in x^2 >= 0;
///   near 0 at r    (x - r)^2 q + a square + a positive number, with such a form of q.
/// Nothing where it is not positive, where that needs more than 40 terms, and above the twelfth degree.
std::optional<GiNaC::ex> positive_form(const GiNaC::ex& polynomial, const GiNaC::symbol& x,
                                       const Interval& range);

}  // namespace rederive
