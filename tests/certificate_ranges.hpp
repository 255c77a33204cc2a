// The range of an expression as far as its form shows it: x^2 + 1 is positive, and so are exp(x), and 1 - x
// for x in (0, 1).
#pragma once

#include <cln/cln.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>

namespace certificate_checker {

/// number + turns*pi, where that is known.
struct Exact {
  cln::cl_RA number = 0, turns = 0;
  bool is_known = false;
  bool is_rational() const { return is_known && cln::zerop(turns); }
};
inline Exact operator+(const Exact& a, const Exact& b) {
  return {a.number + b.number, a.turns + b.turns, a.is_known && b.is_known};
}
inline Exact operator*(const cln::cl_RA& c, const Exact& a) {
  return {c * a.number, c * a.turns, a.is_known};
}

/// The real numbers between two ends.
struct Range {
  long double low = -INFINITY, high = INFINITY;
  bool has_low = false, has_high = false;  ///< the ends themselves
  Exact exact_low = {}, exact_high = {};   ///< beside the rounded ones
  bool is_constant() const {
    return exact_low.is_rational() && exact_high.is_rational() && exact_low.number == exact_high.number;
  }
  bool is_positive() const { return low > 0 || (low == 0 && !has_low); }
  bool is_negative() const { return high < 0 || (high == 0 && !has_high); }
};
/// A rounded end is moved outward, by more than it may be wrong.
inline long double end(long double value, long double size, bool is_exact, int outward) {
  return is_exact ? value : value + outward * 1e-15L * size;
}
inline Range around(long double value) {
  const bool is_exact = std::abs(value) < 9e15L;
  return {end(value, std::abs(value), is_exact, -1), end(value, std::abs(value), is_exact, 1), true, true};
}
/// A rational number times pi, from the one to the other.
inline Range turned(const cln::cl_RA& low, const cln::cl_RA& high, bool has_ends) {
  const long double pi = std::numbers::pi_v<long double>, from = pi * cln::double_approx(low),
                    to = pi * cln::double_approx(high);
  return {end(from, std::abs(from), false, -1),
          end(to, std::abs(to), false, 1),
          has_ends,
          has_ends,
          {0, low, true},
          {0, high, true}};
}
inline Range point(const cln::cl_I& n) {
  Range result = around(cln::double_approx(n));
  result.exact_low = result.exact_high = {n, 0, true};
  return result;
}
/// Not where it is a number of the machine.
inline long double rounded(const cln::cl_RA& n, int outward) {
  const double value = cln::double_approx(n);
  if (!std::isfinite(value)) return cln::minusp(n) == (outward < 0) ? outward * INFINITY : -outward * 1e300L;
  const bool is_exact = cln::rational(cln::cl_DF(value)) == n;
  return is_exact ? value : value + outward * (1e-15L * std::abs(value) + 1e-300L);
}
/// An end that is known is rounded but once.
inline Range with_exact(Range range, const Exact& low, const Exact& high) {
  range.exact_low = low, range.exact_high = high;
  if (low.is_rational()) range.low = rounded(low.number, -1);
  if (high.is_rational()) range.high = rounded(high.number, 1);
  return range;
}
inline Range operator+(const Range& a, const Range& b) {
  const auto sum = [](long double x, long double y, int outward) {
    const long double s = x + y;
    return end(s, std::abs(x) + std::abs(y), s - x == y && s - y == x, outward);
  };
  return with_exact(
      {sum(a.low, b.low, -1), sum(a.high, b.high, 1), a.has_low && b.has_low, a.has_high && b.has_high},
      a.exact_low + b.exact_low, a.exact_high + b.exact_high);
}
inline Range operator*(const Range& a, const Range& b) {
  if (!a.is_constant() && b.is_constant()) return b * a;
  Range result{INFINITY, -INFINITY};
  for (const auto& [x, has_x] : {std::pair{a.low, a.has_low}, {a.high, a.has_high}})
    for (const auto& [y, has_y] : {std::pair{b.low, b.has_low}, {b.high, b.has_high}}) {
      const bool is_zero = x == 0 || y == 0;
      const long double product = is_zero ? 0 : x * y;
      if (std::isnan(product) || (product == 0 && !is_zero)) return {};
      const bool is_exact = is_zero || std::isinf(product) || std::fma(x, y, -product) == 0;
      const long double low = end(product, std::abs(product), is_exact, -1),
                        high = end(product, std::abs(product), is_exact, 1);
      const bool has_end = (has_x && (has_y || x == 0)) || (has_y && y == 0);
      if (low < result.low) result.low = low, result.has_low = false;
      if (high > result.high) result.high = high, result.has_high = false;
      if (low == result.low) result.has_low = result.has_low || has_end;
      if (high == result.high) result.has_high = result.has_high || has_end;
    }
  if (!a.is_constant()) return result;
  const cln::cl_RA by = a.exact_low.number;
  const bool falls = cln::minusp(by);
  return with_exact(result, by * (falls ? b.exact_high : b.exact_low),
                    by * (falls ? b.exact_low : b.exact_high));
}
/// The reciprocals of what has one sign lie between those of its ends.
inline Range operator/(const Range& a, const Range& b) {
  if (b.is_positive() == b.is_negative()) return {};  // 0 may be in it, or nothing is
  if (b.is_negative()) return point(-1) * a / (point(-1) * b);
  const auto over = [](long double x, int outward) {
    const long double q = 1 / std::abs(x);
    return end(q, q, std::isinf(x) || x == 0 || std::fma(q, x, -1.0L) == 0, outward);
  };
  Range reciprocal{over(b.high, -1), over(b.low, 1), b.has_high, b.has_low};
  if (b.is_constant()) reciprocal.exact_low = reciprocal.exact_high = {1 / b.exact_low.number, 0, true};
  return a * reciprocal;
}
/// Of an even power, for which a range was found that does not know of it.
inline Range not_negative(const Range& range) {
  return range.low >= 0 ? range : Range{0, range.high, true, range.has_high};
}

/// Whether an end lies below q*pi (-1), there (0) or above (1); `doubt` where rounding does not tell.
inline int place(long double value, const Exact& exact, const cln::cl_RA& q, int doubt) {
  if (exact.is_known && cln::zerop(exact.number)) return cln::compare(exact.turns, q);
  const long double at = std::numbers::pi_v<long double> * cln::double_approx(q),
                    margin = 1e-15L * std::abs(at);
  return value > at + margin ? 1 : value < at - margin ? -1 : margin > 0 ? doubt : 0;
}
/// Whether it lies between two multiples of pi, for sure; whether one may lie in it.
inline bool lies(const Range& x, const cln::cl_RA& low, const cln::cl_RA& high) {
  return place(x.low, x.exact_low, low, -1) >= 0 && place(x.high, x.exact_high, high, 1) <= 0;
}
inline bool may_have(const Range& x, const cln::cl_RA& q) {
  const int low = place(x.low, x.exact_low, q, -1), high = place(x.high, x.exact_high, q, 1);
  return (low < 0 || (low == 0 && x.has_low)) && (high > 0 || (high == 0 && x.has_high));
}

/// Whether q*pi or another one, whole turns away, may lie in it.
inline bool touches(const Range& x, const cln::cl_RA& q) {
  for (int k = -6; k <= 6; k += 2)
    if (may_have(x, q + k)) return true;
  return false;
}
/// That of a sine or cosine: between its values at the ends, -1 and 1 if x gets there.
inline Range wave(const std::string& f, const Range& x) {
  const cln::cl_RA half = cln::cl_RA(1) / 2, start = f == "sin" ? cln::cl_RA(0) : -half;
  const long double far = 13;
  if (!(x.low > -far && x.high < far)) return {-1, 1, true, true, {-1, 0, true}, {1, 0, true}};
  const auto at = [&](long double from, const Exact& exact, bool has) -> Range {
    const long double value = f == "sin" ? std::sin(from) : std::cos(from), whole = std::round(2 * value);
    const bool is_known = exact.is_known && cln::zerop(exact.number) &&
                          cln::denominator(6 * exact.turns) == 1 && std::abs(2 * value - whole) < 1e-9L;
    if (is_known) return {whole / 2, whole / 2, has, has};  // 0, 1/2 or 1
    return {end(value, 20, false, -1), end(value, 20, false, 1), true, true};
  };
  Range result = at(x.low, x.exact_low, x.has_low);
  const Range other = at(x.high, x.exact_high, x.has_high);
  result.has_low = (result.low <= other.low && result.has_low) || (other.low <= result.low && other.has_low);
  result.has_high =
      (result.high >= other.high && result.has_high) || (other.high >= result.high && other.has_high);
  result.low = std::min(result.low, other.low), result.high = std::max(result.high, other.high);
  for (int k = -5; k <= 5; ++k) {  // half a period of one sign, which has one of the extremes
    const bool is_positive = k % 2 == 0, has_middle = may_have(x, start + k + half);
    if (has_middle && is_positive) result.high = 1, result.has_high = true;
    if (has_middle && !is_positive) result.low = -1, result.has_low = true;
    if (!lies(x, start + k, start + k + 1)) continue;
    const bool has_ends = may_have(x, start + k) || may_have(x, start + k + 1);
    if (is_positive && result.low <= 0) result.low = 0, result.has_low = has_ends;
    if (!is_positive && result.high >= 0) result.high = 0, result.has_high = has_ends;
  }
  if (result.low <= -1) result.low = -1, result.has_low = touches(x, start - half);
  if (result.high >= 1) result.high = 1, result.has_high = touches(x, start + half);
  if (result.low == -1) result.exact_low = {-1, 0, true};
  if (result.high == 1) result.exact_high = {1, 0, true};
  return result;
}

/// That of f(x), or another one where nothing more is known.
inline Range range_of(const std::string& f, const Range& x, const Range& other) {
  using F = long double (*)(long double);
  static const std::map<std::string, F> increasing{
      {"exp", std::exp}, {"sinh", std::sinh}, {"asinh", std::asinh}, {"tanh", std::tanh}};
  const cln::cl_RA half = cln::cl_RA(1) / 2;
  if (const auto found = increasing.find(f); found != increasing.end()) {
    const auto at = [&](long double from, int outward) {
      const long double value = found->second(from);
      return end(value, std::abs(value), from == 0 || std::isinf(from), outward);
    };
    const bool is_small = f == "exp" && !(std::exp(x.low) > 0);
    return {is_small ? 0 : at(x.low, -1), at(x.high, 1), x.has_low && !is_small, x.has_high};
  }
  if (f == "sin" || f == "cos") return wave(f, x);
  if (f == "log") {  // of what is positive
    const auto at = [](long double from, int outward) {
      const long double value = std::log(from);
      return end(value, 1 + std::abs(value), from == 1 || std::isinf(value), outward);
    };
    return {at(std::max(x.low, 0.0L), -1), at(x.high, 1), x.has_low && x.low > 0,
            x.has_high && x.high < INFINITY};
  }
  if (f == "cosh") return {1, INFINITY, may_have(x, 0), false, {1, 0, true}, {}};
  if (f == "asin") return turned(-half, half, true);
  if (f == "acos") return turned(0, 1, true);
  if (f == "atan") {
    Range result = turned(-half, half, false);
    const auto at = [](long double from, int outward) { return end(std::atan(from), 2, from == 0, outward); };
    if (x.low > -1e9L) result.low = at(x.low, -1), result.has_low = x.has_low, result.exact_low = {};
    if (x.high < 1e9L) result.high = at(x.high, 1), result.has_high = x.has_high, result.exact_high = {};
    return result;
  }
  if (f == "fabs") {
    const Range y = point(-1) * x;
    const bool same = y.exact_high.is_known && x.exact_high.is_known &&
                      y.exact_high.number == x.exact_high.number && y.exact_high.turns == x.exact_high.turns;
    const bool left = y.high > x.high + 1e-14L * std::abs(x.high),
               right = x.high > y.high + 1e-14L * std::abs(y.high);
    return {0,
            std::max(x.high, y.high),
            true,
            left    ? y.has_high
            : right ? x.has_high
                    : x.has_high || y.has_high,
            {0, 0, true},
            left            ? y.exact_high
            : right || same ? x.exact_high
                            : Exact{}};
  }
  return f == "acosh" ? Range{0, INFINITY, true, false} : other;
}

/// Whether f grows, or falls, all over two ranges and between them.
inline bool is_monotonic(const std::string& f, bool falls, const Range& x, const Range& y) {
  static const std::set<std::string> grow{"exp",   "log",  "sinh", "asinh", "tanh",
                                          "atanh", "asin", "atan", "acosh", "sin(atan)"};
  if (f[0] == '^' || grow.contains(f)) return !falls && f.substr(0, 2) != "^-";
  if (f == "acos" || f == "cos(atan)") return falls && (f == "acos" || (x.low >= 0 && y.low >= 0));
  const cln::cl_RA start = f == "sin" || f == "tan" ? -cln::cl_RA(1) / 2 : cln::cl_RA(0);
  for (int k = -4; k <= 4; ++k)  // half a period of sin and cos
    if (const bool is_odd = k % 2 != 0;
        lies(x, start + k, start + k + 1) && lies(y, start + k, start + k + 1))
      return (f == "tan" && !falls) || (f == "cot" && falls) || (f == "sin" && falls == is_odd) ||
             (f == "cos" && falls != is_odd);
  return false;
}

}  // namespace certificate_checker
