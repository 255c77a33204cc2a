#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>
#include <map>
#include <stdexcept>
#include <vector>

namespace rederive::inline numbers {

namespace {

using cln::cl_I;
using cln::cl_RA;

constexpr Arithmetic arithmetic{96};

Constant turn(const cl_RA& b) { return {0, b}; }

End infinity(int sign) { return {{}, sign, false}; }
End opened(End x) { return x.closed = false, x; }
Interval both_ends(const End& x) { return {x, x}; }
End negative(const End& x) { return {-1 * x, -x.infinite, x.closed}; }

/// The one further to a side; of equal ones the closed or the open one, as wanted.
const End& further(int side, const End& x, const End& y, bool closed) {
  const int order = side * compare(x, y);
  if (order == 0) return x.closed == closed ? x : y;
  return order > 0 ? x : y;
}

/// The value as an interval. The margin makes sure that no end that was rounded is attained.
Interval enclosing(const Value& value) {
  if (value.constant) return point(*value.constant);
  const cl_RA low = value.ball.lower(), high = value.ball.upper(), margin = high - low;
  return {{{low - margin}}, {{high + margin}}};
}

/// What f makes of an end; `otherwise` where that is infinite, or has no value that can be told.
template <class F>
Interval image(const End& end, const Interval& otherwise, const F& f) {
  const Value value = end.infinite ? Value{} : f(arithmetic.known(Constant(end)));
  if (value.is != Value::Is::certain) return otherwise;
  Interval result = enclosing(value);
  if (!end.closed) result = {opened(result.low), opened(result.high)};
  return result;
}

/// Of a monotone f, with what holds beyond the ends.
template <class F>
Interval between(const Interval& x, const End& at_low, const End& at_high, const F& f) {
  return hull(image(x.low, both_ends(at_low), f), image(x.high, both_ends(at_high), f));
}

Interval product(const End& x, const End& y) {
  const int sign = compare(x, {}) * compare(y, {});
  if (sign == 0)
    return both_ends({{}, 0, (compare(x, {}) == 0 && x.closed) || (compare(y, {}) == 0 && y.closed)});
  if (x.infinite || y.infinite) return both_ends(infinity(sign));
  const End both{x, 0, x.closed && y.closed};
  const Interval otherwise = sign > 0 ? Interval{{}, infinity(1)} : Interval{infinity(-1), {}};
  return image(both, otherwise,
               [&](const Value& v) { return arithmetic.times(v, arithmetic.known(Constant(y))); });
}

Interval absolute(const Interval& x) {
  if (x.is_nonnegative()) return x;
  if (x.is_nonpositive()) return -x;
  return {{{}, 0, true}, further(+1, negative(x.low), x.high, true)};
}

/// A monotone function, where it has values; beyond the ends that have none, it comes near those of its
/// range.
Interval monotone(const std::string& name, int slope, const Interval& given) {
  static const std::map<std::string, Interval> ranges = {{"exp", parse_range("(0, inf)")},
                                                         {"tanh", parse_range("(-1, 1)")},
                                                         {"atan", parse_range("(-1/2*pi, 1/2*pi)")}};
  const auto found = ranges.find(name);
  const Interval range = found == ranges.end() ? Interval{} : found->second;
  const Function& f = function(name);
  const End least = f.least ? End{{*f.least}, 0, true} : infinity(-1);
  const End greatest = f.greatest ? End{{*f.greatest}, 0, true} : infinity(1);
  const Interval x = overlap(given, {least, greatest});
  if (x.is_empty()) return x;
  return overlap(range, between(x, slope > 0 ? range.low : range.high, slope > 0 ? range.high : range.low,
                                [&](const Value& v) { return arithmetic.call(name, v); }));
}

/// The k near (x - from)/period: three whole numbers, one of which is the least k with from + k*period >= x.
/// Nothing where x is infinite or very large.
std::vector<cl_I> periods(const End& x, const Constant& from, const Constant& period) {
  const Ball count = (x - from).ball(96) / period.ball(96);
  if (x.infinite || !count.is_moderate() || cln::abs(count.lower()) > cln::ash(cl_I(1), 64)) return {};
  const cl_I k = cln::floor1(count.lower());
  return {k, k + 1, k + 2};
}

Interval sine(const Interval& x) {
  const Interval all = {{{-1}, 0, true}, {{1}, 0, true}};
  const auto f = [](const Value& v) { return arithmetic.call("sin", v); };
  Interval result = hull(image(x.low, all, f), image(x.high, all, f));
  for (int side : {-1, 1}) {
    const Constant peak = turn(cl_RA(side) / 2);
    const auto counts = periods(x.low, peak, turn(2));
    if (counts.empty() || x.high.infinite) return all;
    for (const cl_I& k : counts) {
      if (x.contains(peak + turn(2 * k))) result = hull(result, point({side}));
    }
  }
  return overlap(result, all);
}

Interval tangent(const Interval& x) {
  for (const cl_I& k : periods(x.low, turn(cl_RA(1) / 2), turn(1))) {
    const End low{turn(k - cl_RA(1) / 2)}, high{turn(k + cl_RA(1) / 2)};
    if (compare(low, x.low) > 0 || compare(x.high, high) > 0) continue;
    return between(x, infinity(-1), infinity(1), [](const Value& v) { return arithmetic.call("tan", v); });
  }
  return {};
}

End read_end(const std::string& text, bool closed, bool is_low) {
  if (text == "inf" || text == "-inf") return infinity(text == "inf" ? 1 : -1);
  const Value value = value_at(parse(text, Symbols()), {}, arithmetic.bits);
  if (value.is != Value::Is::certain) throw std::invalid_argument("an end of a range has no value: " + text);
  const Interval ends = enclosing(value);
  End end = is_low ? ends.low : ends.high;
  end.closed = end.closed && closed;
  return end;
}

}  // namespace

int compare(const End& x, const End& y) {
  return x.infinite || y.infinite ? x.infinite - y.infinite : (x - y).sign();
}

bool Interval::is_empty() const {
  const int order = compare(low, high);
  return order > 0 || (order == 0 && !(low.closed && high.closed));
}

bool Interval::contains(const Constant& x) const {
  const End at{x, 0, true};
  return !overlap(*this, both_ends(at)).is_empty();
}

Interval point(const Constant& x) { return both_ends({x, 0, true}); }

Interval parse_range(std::string_view range) try {
  const Range ends = read_range(range);
  return {read_end(ends.lower, ends.lower_closed, true), read_end(ends.upper, ends.upper_closed, false)};
} catch (const SyntaxError& error) {
  throw std::invalid_argument("the range " + std::string(range) + ": " + error.what());
}

Interval hull(const Interval& x, const Interval& y) {
  return {further(-1, x.low, y.low, true), further(+1, x.high, y.high, true)};
}

Interval overlap(const Interval& x, const Interval& y) {
  return {further(+1, x.low, y.low, false), further(-1, x.high, y.high, false)};
}

Interval operator+(const Interval& x, const Interval& y) {
  const auto sum = [](const End& a, const End& b) {
    return a.infinite ? a : b.infinite ? b : End{Constant(a) + b, 0, a.closed && b.closed};
  };
  return {sum(x.low, y.low), sum(x.high, y.high)};
}

Interval operator-(const Interval& x) { return {negative(x.high), negative(x.low)}; }

Interval operator-(const Interval& x, const Interval& y) { return x + -y; }

Interval operator*(const Interval& x, const Interval& y) {
  return hull(hull(product(x.low, y.low), product(x.low, y.high)),
              hull(product(x.high, y.low), product(x.high, y.high)));
}

Interval reciprocal(const Interval& x) {
  const int side = x.is_nonnegative() ? 1 : x.is_nonpositive() ? -1 : 0;
  if (side == 0) return {};
  const auto at = [&](const End& end) {
    const End otherwise = end.infinite ? End{} : infinity(side);
    return image(end, both_ends(otherwise),
                 [](const Value& v) { return arithmetic.over(arithmetic.known(Constant{1}), v); });
  };
  return hull(at(x.low), at(x.high));
}

Interval power(const Interval& x, long n) {
  if (n < 0) return reciprocal(power(x, -n));
  const Interval base = n % 2 == 0 ? absolute(x) : x;
  if (n == 0) return point({1});
  const End low = base.is_positive() ? End{} : infinity(-1), high = base.is_negative() ? End{} : infinity(1);
  const Interval result = between(
      base, low, high, [&](const Value& v) { return arithmetic.power(v, arithmetic.known(Constant{n})); });
  return n % 2 == 0 ? overlap(result, {{{}, 0, true}, infinity(1)}) : result;
}

Interval call(const std::string& name, const Interval& x) {
  const Constant quarter = turn(cl_RA(1) / 2);
  const int slope = function(name).slope;
  if (slope != 0) return monotone(name, slope, x);
  if (name == "sin") return sine(x);
  if (name == "cos") return sine(x + point(quarter));
  if (name == "tan") return tangent(x);
  if (name == "cot") return tangent(point(quarter) - x);
  if (name == "cosh") return monotone("cosh", 1, absolute(x));
  if (name == "sec") return reciprocal(call("cos", x));
  if (name == "csc") return reciprocal(call("sin", x));
  if (name == "sech") return reciprocal(call("cosh", x));
  if (name == "csch") return reciprocal(call("sinh", x));
  if (name == "coth") return reciprocal(call("tanh", x));
  return absolute(x);
}

}  // namespace rederive::inline numbers
