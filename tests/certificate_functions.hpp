// What functions are made of, and the range of an expression as far as its form shows it: x^2 + 1 is
// positive, and so are exp(x), and 1 - x for x in (0, 1).
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <utility>

namespace certificate_checker {

/// f(x) in terms of $x, or of $u = e^x and $v = 1/$u; for sin and cos $u = e^(ix). Empty for others.
inline std::string meaning_of(const std::string& f) {
  static const std::map<std::string, std::string> meanings{
      {"sin", "($u-$v)*$i/(-2)"},    {"cos", "($u+$v)/2"},       {"sinh", "($u-$v)/2"},
      {"cosh", "($u+$v)/2"},         {"tan", "sin($x)/cos($x)"}, {"cot", "cos($x)/sin($x)"},
      {"sec", "1/cos($x)"},          {"csc", "1/sin($x)"},       {"tanh", "sinh($x)/cosh($x)"},
      {"coth", "cosh($x)/sinh($x)"}, {"sech", "1/cosh($x)"},     {"csch", "1/sinh($x)"},
      {"sqrt", "$x^(1/2)"},          {"fabs", "sqrt($x^2)"}};
  const auto found = meanings.find(f);
  return found == meanings.end() ? "" : found->second;
}

/// The real numbers between two ends.
struct Range {
  long double low = -INFINITY, high = INFINITY;
  bool has_low = false, has_high = false;  ///< the ends themselves
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
inline Range operator+(Range a, Range b) {
  const auto sum = [](long double x, long double y, int outward) {
    const long double s = x + y;
    return end(s, std::abs(x) + std::abs(y), s - x == y && s - y == x, outward);
  };
  return {sum(a.low, b.low, -1), sum(a.high, b.high, 1), a.has_low && b.has_low, a.has_high && b.has_high};
}
inline Range operator*(Range a, Range b) {
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
  return result;
}
/// The reciprocals of what has one sign lie between those of its ends.
inline Range operator/(Range a, Range b) {
  if (b.is_negative()) return a * Range{-1, -1, true, true} / (b * Range{-1, -1, true, true});
  if (!b.is_positive()) return {};
  const auto over = [](long double x, int outward) {
    const long double q = 1 / std::abs(x);
    return end(q, q, std::isinf(x) || x == 0 || std::fma(q, x, -1.0L) == 0, outward);
  };
  return a * Range{over(b.high, -1), over(b.low, 1), b.has_high, b.has_low};
}
/// Of an even power, for which a range was found that does not know of it.
inline Range not_negative(Range range) {
  return range.low >= 0 ? range : Range{0, range.high, true, range.has_high};
}

/// That of f(x), or another one where nothing more is known.
inline Range range_of(const std::string& f, const Range& x, const Range& other) {
  using F = long double (*)(long double);
  static const std::map<std::string, F> increasing{{"exp", std::exp},
                                                   {"sinh", std::sinh},
                                                   {"asinh", std::asinh},
                                                   {"tanh", std::tanh},
                                                   {"atan", std::atan}};
  constexpr long double pi = std::numbers::pi_v<long double>;
  if (f == "exp" && !(std::exp(x.low) > 0)) return {0, INFINITY, false, false};
  if (const auto found = increasing.find(f); found != increasing.end()) {
    const auto at = [&](long double from, int outward) {
      const long double value = found->second(from);
      return end(value, std::abs(value), from == 0, outward);
    };
    return {at(x.low, -1), at(x.high, 1), x.has_low, x.has_high};
  }
  const auto has = [&](long double from) {
    return (x.has_low && x.low == from) || (x.has_high && x.high == from);
  };
  const auto contains = [&](long double inside) {
    return (x.low < inside && inside < x.high) || has(inside);
  };
  if (f == "sin" && x.low >= 0 && x.high <= pi) return {0, 1, has(0) || has(pi), contains(pi / 2)};
  if (f == "sin" && x.low >= -pi && x.high <= 0) return {-1, 0, contains(-pi / 2), has(0) || has(-pi)};
  if (f == "cos" && x.low >= -pi / 2 && x.high <= pi / 2)
    return {0, 1, has(-pi / 2) || has(pi / 2), contains(0)};
  if (f == "sin" || f == "cos") return {-1, 1, true, true};
  if (f == "cosh") return {1, INFINITY, contains(0), false};
  return f == "acos" || f == "acosh" ? Range{0, INFINITY, true, false} : other;
}

/// Whether f grows, or falls, all over two ranges and between them.
inline bool is_monotonic(const std::string& f, const Range& x, const Range& y) {
  constexpr long double half = std::numbers::pi_v<long double> / 2;
  const auto lie = [&](long double low, long double high) {
    return x.low >= low && y.low >= low && x.high <= high && y.high <= high;
  };
  static const std::set<std::string> everywhere{"exp",   "log",  "sinh", "asinh", "tanh",
                                                "atanh", "asin", "atan", "acosh", "acos"};
  return everywhere.contains(f) || ((f == "sin" || f == "tan") && lie(-half, half)) ||
         (f == "cos" && lie(0, 2 * half));
}

}  // namespace certificate_checker
