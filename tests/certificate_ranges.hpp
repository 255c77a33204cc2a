// The range of an expression as far as its form shows it: x^2 + 1 is positive, and so are exp(x), and 1 - x
// for x in (0, 1).
#pragma once

#include <algorithm>
#include <set>
#include <tests/certificate_ends.hpp>

namespace certificate_checker {

inline End product(const End& a, const End& b, int outward) {
  if (sign(a) == 0 || sign(b) == 0) return {};
  if (a.infinite != 0 || b.infinite != 0) return {0, sign(a) * sign(b)};
  return shortened(a * b, outward);
}

/// The real numbers between two ends.
struct Range {
  End low = least, high = most;
  bool has_low = false, has_high = false;  ///< the ends themselves
  bool is_constant() const { return low.is_rational() && high.is_rational() && low.number == high.number; }
  bool is_empty() const {
    const int order = compare(low, high);
    return order > 0 || (order == 0 && !(has_low && has_high));
  }
  bool is_positive() const { return sign(low) > 0 || (sign(low) == 0 && !has_low); }
  bool is_negative() const { return sign(high) < 0 || (sign(high) == 0 && !has_high); }
  bool is_not_negative() const { return sign(low) >= 0; }
  bool is_not_positive() const { return sign(high) <= 0; }
  bool is_zero() const { return is_not_negative() && is_not_positive(); }
};
inline Range point(const End& e) { return {e, e, true, true}; }
inline Range operator+(const Range& a, const Range& b) {
  return {shortened(a.low + b.low, -1), shortened(a.high + b.high, 1), a.has_low && b.has_low,
          a.has_high && b.has_high};
}
inline Range operator*(const Range& a, const Range& b) {
  Range result{most, least};
  for (const auto& [x, has_x] : {std::pair{a.low, a.has_low}, {a.high, a.has_high}})
    for (const auto& [y, has_y] : {std::pair{b.low, b.has_low}, {b.high, b.has_high}}) {
      const End low = product(x, y, -1), high = product(x, y, 1);
      const bool has_end = (has_x && (has_y || sign(x) == 0)) || (has_y && sign(y) == 0);
      if (compare(low, result.low) < 0) result.low = low, result.has_low = false;
      if (compare(high, result.high) > 0) result.high = high, result.has_high = false;
      if (compare(low, result.low) == 0) result.has_low = result.has_low || has_end;
      if (compare(high, result.high) == 0) result.has_high = result.has_high || has_end;
    }
  return result;
}
/// The reciprocals of what has one sign lie between those of its ends.
inline Range operator/(const Range& a, const Range& b) {
  if (b.is_positive() == b.is_negative()) return {};  // 0 may be in it, or nothing is
  if (b.is_negative()) return point({-1}) * a / (point({-1}) * b);
  const auto over = [](const End& x, int outward) -> End {
    if (x.infinite != 0) return {};
    return sign(x) == 0 ? most : power_at(x, -1, outward);
  };
  return a * Range{over(b.high, -1), over(b.low, 1), b.has_high, b.has_low};
}
/// Of what is not 0.
inline Range without_zero(Range x) {
  x.has_low = x.has_low && !x.low.is_zero(), x.has_high = x.has_high && !x.high.is_zero();
  return x;
}
/// What is known of one number in two ways.
inline Range both(const Range& a, const Range& b) {
  const int low = compare(a.low, b.low), high = compare(a.high, b.high);
  return {low > 0 ? a.low : b.low, high < 0 ? a.high : b.high,
          (low < 0 || a.has_low) && (low > 0 || b.has_low),
          (high > 0 || a.has_high) && (high < 0 || b.has_high)};
}
inline bool is_within(const Range& x, const Range& whole) {
  const int low = compare(x.low, whole.low), high = compare(x.high, whole.high);
  return (low > 0 || (low == 0 && (whole.has_low || !x.has_low))) &&
         (high < 0 || (high == 0 && (whole.has_high || !x.has_high)));
}
/// Of an even power, for which a range was found that does not know of it.
inline Range not_negative(const Range& range) {
  return range.is_not_negative() ? range : Range{{}, range.high, true, range.has_high};
}

/// Whether it lies between two multiples of pi; whether one lies in it.
inline bool lies(const Range& x, const cln::cl_RA& low, const cln::cl_RA& high) {
  return compare(x.low, turned(low)) >= 0 && compare(x.high, turned(high)) <= 0;
}
inline bool has(const Range& x, const End& e) {
  const int low = compare(x.low, e), high = compare(x.high, e);
  return (low < 0 || (low == 0 && x.has_low)) && (high > 0 || (high == 0 && x.has_high));
}

/// That of a cosine: between its values at the ends, -1 and 1 if x gets there.
inline Range cosine(Range x) {
  const Range whole{{-1}, {1}, true, true};
  if (x.low.infinite != 0 || x.high.infinite != 0) return whole;
  const cln::cl_R start = digits_of(x.low) / cln::pi(cln::float_format(200));
  if (cln::abs(start) > cln::expt(cln::cl_RA(10), 40)) return whole;
  const End turns = turned(-2 * cln::floor1(start / 2));
  x.low = x.low + turns, x.high = x.high + turns;  // x begins in the first turn
  if (compare(x.high, x.low + turned(2)) > 0) return whole;
  const auto at = [](const End& e, bool has_end) -> Range {
    return {cosine_at(e, -1), cosine_at(e, 1), has_end, has_end};
  };
  const Range a = at(x.low, x.has_low), b = at(x.high, x.has_high);
  const int low = compare(a.low, b.low), high = compare(a.high, b.high);
  Range result{low < 0 ? a.low : b.low, high > 0 ? a.high : b.high,
               (low <= 0 && a.has_low) || (low >= 0 && b.has_low),
               (high >= 0 && a.has_high) || (high <= 0 && b.has_high)};
  for (int k = 0; k <= 4; ++k) {  // at k*pi it is 1 and -1 in turn
    if (!has(x, turned(k))) continue;
    if (k % 2 == 0) result.high = {1}, result.has_high = true;
    if (k % 2 != 0) result.low = {-1}, result.has_low = true;
  }
  return result;
}

/// A function that grows from one point to another, with its values there.
struct Growing {
  cln::cl_N (*f)(const cln::cl_F&);
  End from, at_from, to, at_to, exact, at_exact;  ///< and one between them where its value is exact
  bool is_steep = false;                          ///< far from 0 it has too many digits
};
inline const std::map<std::string, Growing>& growing() {
  using F = const cln::cl_F&;
  using N = cln::cl_N;
  const cln::cl_RA half = cln::cl_RA(1) / 2;
  const End zero, one{1}, minus_one{-1}, left = turned(-half), right = turned(half);
  static const std::map<std::string, Growing> functions{
      {"exp", {[](F x) -> N { return cln::exp(x); }, least, zero, most, most, zero, one, true}},
      {"log", {[](F x) -> N { return cln::ln(x); }, zero, least, most, most, one, zero}},
      {"sinh", {[](F x) -> N { return cln::sinh(x); }, least, least, most, most, zero, zero, true}},
      {"cosh", {[](F x) -> N { return cln::cosh(x); }, zero, one, most, most, zero, one, true}},
      {"tanh", {[](F x) -> N { return cln::tanh(x); }, least, minus_one, most, one, zero, zero}},
      {"asin", {[](F x) -> N { return cln::asin(N(x)); }, minus_one, left, one, right, zero, zero}},
      {"atan", {[](F x) -> N { return cln::atan(N(x)); }, least, left, most, right, zero, zero}},
      {"asinh", {[](F x) -> N { return cln::asinh(N(x)); }, least, least, most, most, zero, zero}},
      {"atanh", {[](F x) -> N { return cln::atanh(N(x)); }, minus_one, least, one, most, zero, zero}},
      {"acosh", {[](F x) -> N { return cln::acosh(N(x)); }, one, zero, most, most, one, zero}}};
  return functions;
}
/// One of them at an end, and whether that is a value of it; none that is further inside.
inline std::pair<End, bool> value_at(const std::string& name, const Growing& g, const End& x, bool has_x,
                                     int outward) {
  const int left = compare(x, g.from), right = compare(x, g.to);
  if (left <= 0) return {g.at_from, g.at_from.infinite == 0 && (has_x || left < 0)};
  if (right >= 0) return {g.at_to, g.at_to.infinite == 0 && (has_x || right > 0)};
  if (compare(x, g.exact) == 0) return {g.at_exact, has_x};
  const cln::cl_F at = digits_of(x);
  const int far = !g.is_steep || cln::abs(at) < cln::cl_I(10000) ? 0 : cln::plusp(at) ? 1 : -1;
  if (far == outward) return {outward > 0 ? g.at_to : g.at_from, false};
  const cln::cl_N value = g.f(far != 0 ? cln::cl_float(cln::cl_I(far * 10000), at) : at);
  const End e = value_at(name, x, cln::cl_float(cln::realpart(value), at), outward);
  if (compare(e, g.at_from) <= 0) return {g.at_from, false};
  return compare(e, g.at_to) >= 0 ? std::pair{g.at_to, false} : std::pair{e, has_x};
}
inline Range range_of(const std::string& name, const Growing& g, const Range& x) {
  const auto [low, has_low] = value_at(name, g, x.low, x.has_low, -1);
  const auto [high, has_high] = value_at(name, g, x.high, x.has_high, 1);
  return {low, high, has_low, has_high};
}
/// That of x^(p/q), where it has a value.
inline Range power_of(const cln::cl_RA& exponent, Range x) {
  if (cln::minusp(exponent)) {
    Range below = power_of(-exponent, x);
    return point({1}) / without_zero(below);
  }
  if (compare(x.low, {}) < 0) x.low = {}, x.has_low = true;
  const auto at = [&](const End& e, int outward) -> End {
    return e.infinite != 0 ? e : sign(e) <= 0 ? End{} : power_at(e, exponent, outward);
  };
  return {at(x.low, -1), at(x.high, 1), x.has_low, x.has_high};
}

/// That of x^n for an odd n > 0, which grows.
inline Range odd_power_of(const cln::cl_RA& n, const Range& x) {
  const auto at = [&](const End& e, int outward) -> End {
    if (e.infinite != 0 || sign(e) == 0) return e;
    return sign(e) > 0 ? power_at(e, n, outward) : cln::cl_RA(-1) * power_at(cln::cl_RA(-1) * e, n, -outward);
  };
  return {at(x.low, -1), at(x.high, 1), x.has_low, x.has_high};
}

/// That of f(x), or another one where nothing more is known.
inline Range range_of(const std::string& f, const Range& x, const Range& other) {
  const cln::cl_RA half = cln::cl_RA(1) / 2;
  if (f == "sin" || f == "cos") return cosine(f == "cos" ? x : x + point(turned(-half)));
  if (f == "acos") return point(turned(half)) + point({-1}) * range_of("asin", x, other);
  if (f == "fabs") {
    const Range y = point({-1}) * x;
    if (x.is_not_negative() || y.is_not_negative()) return x.is_not_negative() ? x : y;
    const int left = compare(y.high, x.high);
    return {
        {}, left > 0 ? y.high : x.high, has(x, {}), (left >= 0 && y.has_high) || (left <= 0 && x.has_high)};
  }
  const auto found = growing().find(f);
  return found == growing().end() ? other
                                  : range_of(f, found->second, f == "cosh" ? range_of("fabs", x, x) : x);
}

/// Whether f has a value all over a range; roots and divisors are seen elsewhere.
inline bool is_defined(const std::string& f, const Range& x) {
  const Range from_1 = x + point({-1}), to_1 = point({1}) + point({-1}) * x, from_minus_1 = x + point({1});
  if (f == "log") return x.is_positive();
  if (f == "asin" || f == "acos") return from_minus_1.is_not_negative() && to_1.is_not_negative();
  if (f == "atanh") return from_minus_1.is_positive() && to_1.is_positive();
  return f != "acosh" || from_1.is_not_negative();
}

/// Whether f grows, or falls, all over two ranges and between them.
inline bool is_monotonic(const std::string& f, bool falls, const Range& x, const Range& y) {
  static const std::set<std::string> grow{"exp",   "log",  "sinh", "asinh", "tanh",
                                          "atanh", "asin", "atan", "acosh", "sin(atan)"};
  if (f[0] == '^' || grow.contains(f)) return !falls && f.substr(0, 2) != "^-";
  if (f == "acos" || f == "cos(atan)")
    return falls && (f == "acos" || (x.is_not_negative() && y.is_not_negative()));
  const cln::cl_RA start = f == "sin" || f == "tan" ? -cln::cl_RA(1) / 2 : cln::cl_RA(0);
  for (int k = -4; k <= 4; ++k)  // half a period of sin and cos
    if (const bool is_odd = k % 2 != 0;
        lies(x, start + k, start + k + 1) && lies(y, start + k, start + k + 1))
      return (f == "tan" && !falls) || (f == "cot" && falls) || (f == "sin" && falls == is_odd) ||
             (f == "cos" && falls != is_odd);
  return false;
}

}  // namespace certificate_checker
