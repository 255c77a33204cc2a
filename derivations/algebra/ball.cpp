#include <derivations/algebra/ball.hpp>

namespace rederive {

using cln::cl_F;
using cln::cl_I;
using cln::cl_R;
using cln::cl_RA;

namespace {

constexpr long largest_exponent = 1'000'000;  // of e: beyond it, there is nothing to look at
constexpr int rough_digits = 20;  // a long float of CLN: fewer would be a double, and overflow at 1e308

bool is_rational(const cl_R& x) { return cln:: instanceof (x, cln::cl_RA_ring); }
bool is_integer(const cl_R& x) { return cln:: instanceof (x, cln::cl_I_ring); }
bool is_zero(const Ball& x) { return x.exact() && cln::zerop(x.middle); }
cl_RA rational(const Ball& x) { return cln::the<cl_RA>(x.middle); }
Ball exactly(const cl_R& x) { return {x}; }

}  // namespace

bool is_positive(const Ball& x) { return x.middle > x.radius; }
bool is_negative(const Ball& x) { return -x.middle > x.radius; }

BallArithmetic::BallArithmetic(int digits)
    : format_(cln::float_format(static_cast<std::uintptr_t>(digits) + 10)),
      unit_(rough(cl_RA(1) / cln::expt_pos(cl_I(10), digits))),
      slack_(rough(1 + cl_RA(1) / cln::expt_pos(cl_I(10), rough_digits - 5))) {}

cl_R BallArithmetic::rough(const cl_R& x) const { return cln::cl_float(x, cln::float_format(rough_digits)); }
cl_F BallArithmetic::fine(const cl_R& x) const { return cln::cl_float(x, format_); }

/// Keeps what is rational and of bearable size; else rounds, and counts the error of doing so.
Ball BallArithmetic::rounded(const cl_R& middle, const cl_R& radius) const {
  constexpr std::uintptr_t bearable_bits = 20'000;
  if (is_rational(middle) && cln::zerop(radius)) {
    const cl_RA ratio = cln::the<cl_RA>(middle);
    const auto bits =
        cln::integer_length(cln::numerator(ratio)) + cln::integer_length(cln::denominator(ratio));
    if (bits < bearable_bits) return exactly(middle);
  }
  const cl_F value = fine(middle);
  return {value, slack_ * rough(radius) + rough(cln::abs(value)) * unit_};
}

Ball BallArithmetic::pi() const {
  const cl_F value = cln::pi(format_);
  return {value, rough(value) * unit_, cl_RA(1)};
}

Ball BallArithmetic::negative(const Ball& x) const {
  Ball result{-x.middle, x.radius};
  result.of_pi = -x.of_pi;
  return result;
}

Ball BallArithmetic::plus(const Ball& x, const Ball& y) const {
  if (x.is_of_pi() && y.is_of_pi()) return times(exactly(x.of_pi + y.of_pi), pi());
  // The rounding error of a sum is relative to what is added, not to what remains.
  Ball sum = rounded(x.middle + y.middle, x.radius + y.radius);
  if (!sum.exact()) sum.radius = sum.radius + (rough(cln::abs(x.middle)) + rough(cln::abs(y.middle))) * unit_;
  return sum;
}

Ball BallArithmetic::times(const Ball& x, const Ball& y) const {
  if (is_zero(x) || is_zero(y)) return exactly(0);
  const cl_R radius = cln::abs(x.middle) * y.radius + cln::abs(y.middle) * x.radius + x.radius * y.radius;
  Ball product = rounded(x.middle * y.middle, radius);
  if (x.exact()) product.of_pi = rational(x) * y.of_pi;
  if (y.exact()) product.of_pi = rational(y) * x.of_pi;
  return product;
}

Ball BallArithmetic::over(const Ball& x, const Ball& y) const {
  const cl_R nearest = Ball{cln::abs(y.middle), y.radius}.least();  // to zero
  if (!cln::plusp(nearest)) throw NoValue{is_zero(y)};
  if (x.is_of_pi() && y.is_of_pi()) return exactly(x.of_pi / y.of_pi);
  const cl_R quotient = x.middle / y.middle;
  Ball result = rounded(quotient, (x.radius + cln::abs(quotient) * y.radius) / nearest);
  if (y.exact()) result.of_pi = x.of_pi / rational(y);
  return result;
}

Ball BallArithmetic::whole_power(const Ball& x, const cl_I& n) const {
  if (cln::zerop(n)) return is_positive(x) || is_negative(x) ? exactly(1) : throw NoValue{};
  if (cln::minusp(n)) return over(exactly(1), whole_power(x, -n));
  Ball result = exactly(1), square = x;
  for (cl_I rest = n; !cln::zerop(rest); rest = cln::ash(rest, -1)) {
    if (cln::oddp(rest)) result = times(result, square);
    if (rest > 1) square = times(square, square);
  }
  return result;
}

Ball BallArithmetic::power(const Ball& x, const Ball& y) const {
  constexpr long largest = 10'000;
  if (y.exact() && is_integer(y.middle) && cln::abs(y.middle) <= largest) {
    return whole_power(x, cln::the<cl_I>(y.middle));
  }
  if (is_zero(x) && is_positive(y)) return exactly(0);
  if (y.exact() && cln::denominator(rational(y)) == 2 && cln::abs(y.middle) <= largest)
    return whole_power(sqrt(x), cln::numerator(rational(y)));
  return exp(times(y, log(x)));
}

Ball BallArithmetic::absolute(const Ball& x) const {
  Ball result{cln::abs(x.middle), x.radius};
  result.of_pi = cln::abs(x.of_pi);
  return result;
}

Ball BallArithmetic::sqrt(const Ball& x) const {
  if (is_zero(x)) return exactly(0);
  if (!is_positive(x)) throw NoValue{is_negative(x)};
  cl_RA root;
  if (x.exact() && cln::sqrtp(rational(x), &root)) return exactly(root);
  return rounded(cln::sqrt(fine(x.middle)), x.radius / cln::sqrt(rough(x.least())));
}

Ball BallArithmetic::exp(const Ball& x) const {
  if (is_zero(x)) return exactly(1);
  if (cln::abs(x.middle) > largest_exponent || x.radius > 1) throw NoValue{};
  const cl_R value = cln::exp(fine(x.middle));
  return rounded(value, 2 * rough(value) * x.radius);  // e^r - 1 < 2 r for r < 1
}

Ball BallArithmetic::log(const Ball& x) const {
  if (x.exact() && x.middle == 1) return exactly(0);
  if (!is_positive(x)) throw NoValue{is_zero(x) || is_negative(x)};
  Ball result = rounded(cln::ln(fine(x.middle)), x.radius / x.least());
  result.radius = result.radius + unit_;  // near 1, the rounding of x counts
  return result;
}

/// The argument of sin and cos, if the digits after its point are known at all.
cl_F BallArithmetic::reducible(const Ball& x) const {
  if (cln::abs(x.middle) * unit_ > 1) throw NoValue{};
  return fine(x.middle);
}

Ball BallArithmetic::sin(const Ball& x) const {
  if (is_zero(x)) return exactly(0);
  if (x.is_of_pi()) return cos(plus(x, times(exactly(cl_RA(-1) / 2), pi())));
  const cl_F argument = reducible(x);
  return rounded(cln::sin(argument), x.radius + rough(cln::abs(argument)) * unit_);
}

Ball BallArithmetic::cos(const Ball& x) const {
  if (is_zero(x)) return exactly(1);
  if (x.is_of_pi()) {  // at multiples of π/3 and π/2 the value is rational
    const cl_R sixths = cln::abs(x.of_pi * 6 - 12 * cln::round1(x.of_pi / 2));
    if (sixths == 0) return exactly(1);
    if (sixths == 2) return exactly(cl_RA(1) / 2);
    if (sixths == 3) return exactly(0);
    if (sixths == 4) return exactly(cl_RA(-1) / 2);
    if (sixths == 6) return exactly(-1);
  }
  const cl_F argument = reducible(x);
  return rounded(cln::cos(argument), x.radius + rough(cln::abs(argument)) * unit_);
}

Ball BallArithmetic::sinh(const Ball& x) const {
  if (is_zero(x)) return exactly(0);
  const Ball up = exp(x), down = exp(negative(x));
  return times(exactly(cl_RA(1) / 2), plus(up, negative(down)));
}

Ball BallArithmetic::cosh(const Ball& x) const {
  if (is_zero(x)) return exactly(1);
  return times(exactly(cl_RA(1) / 2), plus(exp(x), exp(negative(x))));
}

Ball BallArithmetic::atan(const Ball& x) const {
  if (is_zero(x)) return exactly(0);
  if (x.exact() && cln::abs(x.middle) == 1) return times(exactly(rational(x) / 4), pi());
  return rounded(cln::atan(fine(x.middle)), x.radius + rough(cln::abs(x.middle)) * unit_);
}

Ball BallArithmetic::asin(const Ball& x) const {
  if (x.exact() && cln::abs(x.middle) == 1) return times(exactly(rational(x) / 2), pi());
  const Ball cosine = sqrt(plus(exactly(1), negative(times(x, x))));
  return atan(over(x, cosine));
}

Ball BallArithmetic::asinh(const Ball& x) const {
  if (cln::minusp(x.middle)) return negative(asinh(negative(x)));
  return log(plus(x, sqrt(plus(times(x, x), exactly(1)))));
}

Ball BallArithmetic::acosh(const Ball& x) const {
  if (x.middle < 1) throw NoValue{};
  return log(plus(x, sqrt(plus(times(x, x), exactly(-1)))));
}

Ball BallArithmetic::atanh(const Ball& x) const {
  const Ball one = exactly(1);
  return times(exactly(cl_RA(1) / 2), log(over(plus(one, x), plus(one, negative(x)))));
}

}  // namespace rederive
