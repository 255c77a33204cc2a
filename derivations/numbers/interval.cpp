#include <derivations/language/functions.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/numbers/interval.hpp>

namespace rederive::numbers {
using namespace language;
namespace {
using cln::cl_RA;

constexpr long bits = 96;

End infinity(int sign) { return {{}, sign}; }
const Interval nonnegative{{{}, 0, true}, infinity(1)};

/// Returns the end that is further to a side; of equal ends, the closed one if `closed`, else the open one.
const End& further(int side, const End& x, const End& y, bool closed) {
  const int order = side * compare(x, y);
  return order > 0 || (order == 0 && x.closed == closed) ? x : y;
}

/// Returns the value as an interval. A margin ensures that no rounded end is attained.
Interval enclosing(const Value& value, bool closed) {
  if (value.constant) return {{*value.constant, 0, closed}, {*value.constant, 0, closed}};
  const cl_RA low = value.ball().lower(), high = value.ball().upper(), margin = high - low;
  return {{{low - margin}}, {{high + margin}}};
}

/// Returns f of an end, or its limit if that is infinite or has no value that can be computed.
template <class F>
Interval image(const End& end, const End& limit, const F& f) {
  const Value value = end.infinite ? Value{} : f(known(Constant(end), bits));
  return value.is == Value::Is::certain ? enclosing(value, end.closed) : Interval{limit, limit};
}

/// Returns the values of a monotone f, with its limits at ends that have no value.
template <class F>
Interval image(const Interval& x, const End& at_low, const End& at_high, const F& f) {
  return hull(image(x.low, at_low, f), image(x.high, at_high, f));
}

Interval product(const End& x, const End& y) {
  const int sign_x = compare(x, {}), sign_y = compare(y, {}), sign = sign_x * sign_y;
  const End zero{{}, 0, (sign_x == 0 && x.closed) || (sign_y == 0 && y.closed)};
  if (sign == 0) return {zero, zero};
  if (x.infinite || y.infinite) return {infinity(sign), infinity(sign)};
  const Value value = known(Constant(x), bits) * known(Constant(y), bits);
  if (value.is != Value::Is::certain) return sign > 0 ? nonnegative : -nonnegative;
  return enclosing(value, x.closed && y.closed);
}

Interval absolute(const Interval& x) {
  if (x.is_nonnegative()) return x;
  return x.is_nonpositive() ? -x : overlap(hull(x, -x), nonnegative);
}

/// Returns an end as an interval, which surrounds an end that is not a + b*pi.
Interval read_end(const std::string& text, bool is_closed) {
  if (text == "inf") return {infinity(1), infinity(1)};
  if (text == "-inf") return {infinity(-1), infinity(-1)};
  const Value value = value_at(parse(text, Symbols()), {}, bits);
  if (value.is != Value::Is::certain) throw std::invalid_argument("an end of a range has no value: " + text);
  return enclosing(value, is_closed);
}

Interval interval_of(const Function::Domain& domain) {
  const auto end = [&](double at) {
    return std::isinf(at) ? infinity(at < 0 ? -1 : 1) : End{{static_cast<long>(at)}, 0, !domain.is_open};
  };
  return {end(domain.least), end(domain.most)};
}

}  // namespace

const MonotonePiece& monotone_piece(const std::string& name) {
  static const auto table = [] {
    std::map<std::string, MonotonePiece> made;
    for (const Function& f : functions()) {
      if (f.values.empty()) continue;
      const Interval domain = f.piece.empty() ? interval_of(f.domain) : parse_range(f.piece);
      made.emplace(f.name, MonotonePiece{domain, parse_range(f.values), std::string(f.inverse), f.half_turn});
    }
    return made;
  }();
  return table.at(name);
}

int compare(const End& x, const End& y) {
  if (x.infinite || y.infinite) return x.infinite - y.infinite;
  return x.is_rational() && y.is_rational() ? cln::compare(x.a, y.a) : (x - y).sign();
}

bool Interval::is_empty() const {
  const int order = compare(low, high);
  return order > 0 || (order == 0 && !(low.closed && high.closed));
}

bool Interval::contains(const Constant& x) const {
  return compare({x}, low) + low.closed > 0 && compare(high, {x}) + high.closed > 0;
}

Interval point(const Constant& x) { return {{x, 0, true}, {x, 0, true}}; }

Interval parse_range(std::string_view range) try {
  thread_local std::map<std::string, Interval, std::less<>> known;
  if (const auto found = known.find(range); found != known.end()) return found->second;
  const Range ends = read_range(range);
  if (known.size() > 400) known.clear();
  return known[std::string(range)] = {read_end(ends.lower, ends.lower_closed).low,
                                      read_end(ends.upper, ends.upper_closed).high};
} catch (const SyntaxError& error) {
  throw std::invalid_argument("the range " + std::string(range) + ": " + error.what());
}

Interval hull(const Interval& x, const Interval& y) {
  return {further(-1, x.low, y.low, true), further(+1, x.high, y.high, true)};
}

Interval overlap(const Interval& x, const Interval& y) {
  return {further(+1, x.low, y.low, false), further(-1, x.high, y.high, false)};
}

bool is_within(const Interval& x, const Interval& y) {
  const auto lies_in = [](const End& end, const End& bound, int side) {
    const int order = side * compare(end, bound);
    return order < 0 || (order == 0 && (bound.closed || !end.closed));
  };
  return lies_in(x.high, y.high, 1) && lies_in(x.low, y.low, -1);
}

Interval operator+(const Interval& x, const Interval& y) {
  const auto sum = [](const End& a, const End& b) {
    return a.infinite ? a : b.infinite ? b : End{Constant(a) + b, 0, a.closed && b.closed};
  };
  return {sum(x.low, y.low), sum(x.high, y.high)};
}

Interval operator-(const Interval& x) {
  const auto negative = [](const End& end) { return End{-1 * end, -end.infinite, end.closed}; };
  return {negative(x.high), negative(x.low)};
}

Interval operator-(const Interval& x, const Interval& y) { return x + -y; }

Interval operator*(const Interval& x, const Interval& y) {
  return hull(hull(product(x.low, y.low), product(x.low, y.high)),
              hull(product(x.high, y.low), product(x.high, y.high)));
}

Interval reciprocal(const Interval& x) {
  const int side = x.is_nonnegative() ? 1 : x.is_nonpositive() ? -1 : 0;
  if (side == 0) return {};
  return image(x, side > 0 ? infinity(1) : End{}, side > 0 ? End{} : infinity(-1),
               [](const Value& v) { return known(Ball(1)) / v; });
}

Interval power(const Interval& x, const cl_RA& exponent) {
  if (cln::minusp(exponent)) return reciprocal(power(x, -exponent));
  if (cln::zerop(exponent)) return point({1});
  const bool is_root = cln::denominator(exponent) != 1, is_even = cln::evenp(cln::numerator(exponent));
  const Interval base = is_root ? overlap(x, nonnegative) : is_even ? absolute(x) : x;
  const End low = base.is_positive() ? End{} : infinity(-1), high = base.is_negative() ? End{} : infinity(1);
  const Interval result =
      image(base, low, high, [&](const Value& v) { return pow(v, known(Constant{exponent}, bits)); });
  return is_root || is_even ? overlap(result, nonnegative) : result;
}

Interval call(const std::string& name, const Interval& x) {
  const Function& f = function_named(name);
  if (!f.reciprocal.empty()) return reciprocal(call(std::string(f.reciprocal), x));
  const auto& [domain, values, inverse, half_turn, range] = monotone_piece(name);
  const auto on_piece = [&, &domain = domain, &values = values, &range = range](const Interval& y) {
    const Interval given = overlap(y, domain);
    const auto value = [&](const Value& v) { return call(name, v); };
    return given.is_empty() ? given : overlap(range, image(given, values.low, values.high, value));
  };
  if (half_turn == 0) return on_piece(f.parity == Function::Parity::even ? absolute(x) : x);
  constexpr int most = 8;  // half turns from 0
  if (compare(x.low, {{0, -most}}) < 0 || compare(x.high, {{0, most}}) > 0) return range;
  std::optional<Interval> result;  // the hull of what the pieces give, each moved to the one around 0
  for (int k = -most - 1; k <= most; ++k) {
    Interval piece = on_piece(x - point({0, k}));
    if (piece.is_empty()) continue;
    if (half_turn < 0 && k % 2 != 0) piece = -piece;
    result = result ? hull(*result, piece) : piece;
  }
  return result.value_or(range);  // a pole alone
}

}  // namespace rederive::numbers
