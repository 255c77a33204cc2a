// Sums of one sign, so written that their range shows it: what interval.hpp sees term by term is too wide.
#pragma once

#include <derivations/algebra/interval.hpp>
#include <optional>

namespace rederive {

/// The same expression, so written that interval_of may show that it is positive or negative, or not one of
/// the two. One of
///   A + B sin x + C cos x     with A^2 >= B^2 + C^2: a square of sin(x/2) and cos(x/2), and what is left;
///   B sin x + C cos x         B/cos(y) sin(x + y) with tan(y) = C/B, where that is 1, sqrt(3) or 1/sqrt(3);
///   A^2 + B^2 - (A sin x + B cos x)^2    (A cos x - B sin x)^2;
///   A sinh(x) + B cosh(x)     (A + B) sinh(x) + B exp(-x);
///   A exp(x) + B exp(-x) + C  (A + B) cosh(x) + (A - B) sinh(x) + C;
///   m g - m g cos x + ...     m g (1 - cos x) + ...: the terms with the same symbols together;
///   sqrt(A) - B               with A >= B^2: ((sqrt(A) - B)^2 + A - B^2)/(2 sqrt(A));
///   A log(u) - A log(v)       A log(1 + (u - v)/v); and the same for atan;
///   a polynomial in one symbol, or in sin x and cos x, or exp(x): positive.hpp; in several: two_squares.hpp,
///   and in several symbols or functions binomial_squares.hpp.
/// Nothing for anything else, and where no such form is found.
std::optional<GiNaC::ex> form_of_one_sign(const GiNaC::ex& sum, const Symbols& symbols);

}  // namespace rederive
