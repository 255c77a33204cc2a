#include <algorithm>
#include <cmath>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/evaluate.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <map>
#include <regex>
#include <stdexcept>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

/// The largest whole number of half turns in a constant angle; nothing beyond 50 digits.
std::optional<numeric> half_turns_in(const ex& angle) {
  const ex turns = (angle / GiNaC::Pi).expand();
  if (turns.info(GiNaC::info_flags::rational))
    return numeric(cln::floor1(cln::the<cln::cl_RA>(ex_to<numeric>(turns).to_cl_N())));
  const auto value = evaluate(to_tree(turns), {}, 60);
  const bool is_known = value && cln::abs(*value) < cln::expt_pos(cln::cl_I(10), 50);
  return is_known ? std::optional(numeric(cln::floor1(*value))) : std::nullopt;
}

int compare(const End& a, const End& b) {
  if (a.infinite != 0 || b.infinite != 0) return (a.infinite > b.infinite) - (a.infinite < b.infinite);
  return rederive::compare(a.value, b.value);
}

int sign(const End& end) { return end.infinite != 0 ? end.infinite : rederive::compare(end.value, 0); }

Interval point(const ex& value) { return {{value, 0, true}, {value, 0, true}}; }

End smaller(const End& a, const End& b) {
  const int order = compare(a, b);
  if (order == 0) return a.closed ? a : b;
  return order < 0 ? a : b;
}
End larger(const End& a, const End& b) {
  const int order = compare(a, b);
  if (order == 0) return a.closed ? a : b;
  return order > 0 ? a : b;
}
Interval hull(const std::vector<End>& ends) {
  Interval result{ends.front(), ends.front()};
  for (const End& end : ends) {
    result.low = smaller(result.low, end);
    result.high = larger(result.high, end);
  }
  return result;
}

End sum(const End& a, const End& b, int towards) {
  if (a.infinite != 0 || b.infinite != 0) return {0, towards, false};
  return {a.value + b.value, 0, a.closed && b.closed};
}

/// 0·∞ is 0 here: the product of the two sets comes as near to 0 as one likes.
End product(const End& a, const End& b) {
  const int signs = sign(a) * sign(b);
  if (signs == 0) {
    const bool closed = (sign(a) == 0 && a.closed) || (sign(b) == 0 && b.closed);
    return {0, 0, closed};
  }
  if (a.infinite != 0 || b.infinite != 0) return {0, signs, false};
  return {a.value * b.value, 0, a.closed && b.closed};
}

Interval product(const Interval& a, const Interval& b) {
  return hull(
      {product(a.low, b.low), product(a.low, b.high), product(a.high, b.low), product(a.high, b.high)});
}

/// Of what is defined: 0 itself has no reciprocal, so that [0, 2] becomes [1/2, inf).
Interval reciprocal(const Interval& i) {
  if (sign(i.low) < 0 && sign(i.high) > 0) return {};
  if (sign(i.low) == 0 && sign(i.high) == 0) return {};
  const auto turn = [](const End& end, int side) -> End {
    if (end.infinite != 0) return {0, 0, false};
    if (end.value.is_zero()) return {0, side, false};
    return {1 / end.value, 0, end.closed};
  };
  const int side = sign(i.high) > 0 ? 1 : -1;
  return {turn(i.high, side), turn(i.low, side)};
}

Interval power(const Interval& base, const numeric& exponent) {
  if (exponent.is_negative()) return reciprocal(power(base, -exponent));
  const auto raise = [&](const End& end) -> End {
    if (end.infinite != 0) return {0, end.infinite > 0 || exponent.is_even() ? 1 : -1, false};
    return {GiNaC::pow(end.value, exponent), 0, end.closed};
  };
  if (exponent.is_integer() && exponent.is_even()) {
    Interval result = hull({raise(base.low), raise(base.high)});
    if (sign(base.low) * sign(base.high) < 0) result.low = {0, 0, true};
    return result;
  }
  if (!exponent.is_integer() && sign(base.low) < 0) {  // a root is defined where its base is not negative
    if (sign(base.high) < 0) return {};
    return {End{0, 0, true}, raise(base.high)};  // End by name: see function_interval
  }
  return {raise(base.low), raise(base.high)};
}

/// A function that grows over the whole of its domain; `bottom` and `top` are its limits.
template <class F>
Interval increasing(const Interval& i, F f, const End& bottom, const End& top) {
  const auto map = [&](const End& end) -> End {
    if (end.infinite != 0) return end.infinite < 0 ? bottom : top;
    return {f(end.value), 0, end.closed};
  };
  return {map(i.low), map(i.high)};
}

/// cos over an interval: the ends, and the extrema kπ inside.
Interval cosine(const Interval& i) {
  const Interval whole{{-1, 0, true}, {1, 0, true}};
  if (i.low.infinite != 0 || i.high.infinite != 0) return whole;
  const auto turns = half_turns_in(i.low.value);
  if (!turns) return whole;
  std::vector<End> ends{{GiNaC::cos(i.low.value), 0, i.low.closed},
                        {GiNaC::cos(i.high.value), 0, i.high.closed}};
  for (int step = -1; step < 5; ++step) {
    const numeric k = *turns + step;
    const End extremum{k * GiNaC::Pi, 0, true};
    if (compare(extremum, i.low) > 0 && compare(extremum, i.high) < 0)
      ends.push_back({k.is_even() ? 1 : -1, 0, true});
  }
  if (compare(End{i.low.value + 2 * GiNaC::Pi, 0, true}, i.high) < 0) return whole;
  return hull(ends);
}

Interval shifted(const Interval& i, const ex& by) {
  Interval result = i;
  if (result.low.infinite == 0) result.low.value += by;
  if (result.high.infinite == 0) result.high.value += by;
  return result;
}

Interval tangent(const Interval& i) {
  const End left{-GiNaC::Pi / 2, 0, false}, right{GiNaC::Pi / 2, 0, false};
  if (compare(i.low, left) < 0 || compare(i.high, right) > 0) return {};
  const auto map = [&](const End& end, const End& edge, int side) -> End {
    if (compare(end, edge) == 0) return {0, side, false};
    return {GiNaC::tan(end.value), 0, end.closed};
  };
  return {map(i.low, left, -1), map(i.high, right, +1)};
}

Interval function_interval(const std::string& name, const Interval& i) {
  const End minus{0, -1, false}, plus{0, +1, false}, zero{0, 0, false};
  const auto at = [](const ex& v) { return End{v, 0, false}; };
  if (name == "exp")
    return increasing(
        i, [](const ex& v) { return GiNaC::exp(v); }, zero, plus);
  if (name == "sinh")
    return increasing(
        i, [](const ex& v) { return GiNaC::sinh(v); }, minus, plus);
  if (name == "asinh")
    return increasing(
        i, [](const ex& v) { return GiNaC::asinh(v); }, minus, plus);
  if (name == "tanh")
    return increasing(
        i, [](const ex& v) { return GiNaC::tanh(v); }, at(-1), at(1));
  if (name == "atan")
    return increasing(
        i, [](const ex& v) { return GiNaC::atan(v); }, at(-GiNaC::Pi / 2), at(GiNaC::Pi / 2));
  if (name == "asin" && compare(i.low, at(-1)) >= 0 && compare(i.high, at(1)) <= 0)
    return increasing(
        i, [](const ex& v) { return GiNaC::asin(v); }, minus, plus);
  if (name == "asin") return {{-GiNaC::Pi / 2, 0, true}, {GiNaC::Pi / 2, 0, true}};
  if (name == "acosh") return {{0, 0, true}, plus};
  if (name == "acos") return {{0, 0, true}, {GiNaC::Pi, 0, true}};
  if (name == "log" && sign(i.low) >= 0) {
    const Interval inner{sign(i.low) == 0 ? End{0, -1, false} : i.low, i.high};
    return increasing(
        inner, [](const ex& v) { return GiNaC::log(v); }, minus, plus);
  }
  if (name == "cosh") {
    const Interval size = function_interval("abs", i);
    return increasing(
        size, [](const ex& v) { return GiNaC::cosh(v); }, at(1), plus);
  }
  if (name == "abs") {
    if (sign(i.low) >= 0) return i;
    Interval flipped = product(i, point(-1));
    if (sign(i.high) <= 0) return flipped;
    // Where larger() throws, GCC 12 destroys an End without a name twice.
    return {End{0, 0, true}, larger(flipped.high, i.high)};
  }
  if (name == "cos") return cosine(i);
  if (name == "sin") return cosine(shifted(i, -GiNaC::Pi / 2));
  if (name == "tan") return tangent(i);
  return {};
}

Interval enclose(const ex& e, const Symbols& symbols);
Interval enclose_as_it_stands(const ex& e, const Symbols& symbols);

/// A square is not negative, whatever is known of its base.
Interval power_interval(const ex& e, const Symbols& symbols) {
  const numeric exponent = ex_to<numeric>(e.op(1));
  try {
    return power(enclose(e.op(0), symbols), exponent);
  } catch (const std::exception&) {  // ends that are too close to tell, or poles of GiNaC
    if (!exponent.is_even()) throw;
    return {{0, 0, true}, {0, +1, false}};
  }
}

/// By what the ranges of other symbols say of it, if it has no more symbols in those; and fewer of the ones
/// that can be said otherwise, so that this comes to an end.
Interval enclose_otherwise(const ex& e, Interval interval, const Symbols& symbols) {
  const auto count = [&](const ex& words) {
    return std::count_if(symbols.otherwise().begin(), symbols.otherwise().end(),
                         [&](const auto& pair) { return words.has(pair.first); });
  };
  for (const auto& [symbol, words] : symbols.otherwise()) {
    if (!e.has(symbol)) continue;
    const ex otherwise = e.subs(symbol == words, GiNaC::subs_options::no_pattern).expand();
    if (names_in(otherwise).size() <= names_in(e).size() && count(otherwise) < count(e))
      interval = overlap(interval, enclose_as_it_stands(otherwise, symbols));
  }
  return interval;
}

Interval enclose(const ex& e, const Symbols& symbols) {
  const bool is_linear = is_a<GiNaC::add>(e) || is_a<GiNaC::mul>(e) || is_a<GiNaC::symbol>(e);
  const Interval interval = enclose_as_it_stands(e, symbols);
  return is_linear && !symbols.otherwise().empty() ? enclose_otherwise(e, interval, symbols) : interval;
}

Interval enclose_as_it_stands(const ex& e, const Symbols& symbols) {
  if (is_a<numeric>(e) || is_a<GiNaC::constant>(e)) return point(e);
  if (is_a<GiNaC::symbol>(e)) {
    const Symbol* symbol = symbols.find(e);
    return symbol != nullptr ? parse_range(symbol->range) : Interval{};
  }
  if (is_a<GiNaC::add>(e)) {
    Interval result = point(0);
    for (const ex& term : e) {
      const Interval i = enclose(term, symbols);
      result = {sum(result.low, i.low, -1), sum(result.high, i.high, +1)};
    }
    return result;
  }
  if (is_a<GiNaC::mul>(e)) {
    Interval result = point(1);
    for (const ex& factor : e) result = product(result, enclose(factor, symbols));
    return result;
  }
  if (is_a<GiNaC::power>(e) && is_a<numeric>(e.op(1)) && ex_to<numeric>(e.op(1)).is_rational())
    return power_interval(e, symbols);
  if (is_a<GiNaC::power>(e)) {  // a^b with a symbolic exponent is 0 only where a is; or anything, if a < 0
    const Interval base = enclose(e.op(0), symbols);
    if (sign(base.low) < 0) return {};
    const bool positive = sign(base.low) > 0 || (sign(base.low) == 0 && !base.low.closed);
    return {{0, 0, !positive}, {0, +1, false}};
  }
  if (is_a<GiNaC::function>(e) && e.nops() == 1)
    return function_interval(ex_to<GiNaC::function>(e).get_name(), enclose(e.op(0), symbols));
  return {};
}

/// Whether a text is made of numbers, π, and powers of e with two digits and roots of four at most.
bool is_constant(std::string text) {
  static const std::regex power("exp\\(-?\\d\\d?(/\\d\\d?)?\\)|sqrt\\(\\d{1,4}\\)");
  text = std::regex_replace(text, power, "1");
  return !text.empty() && text.find_first_not_of("0123456789/*-+pi()") == std::string::npos;
}

/// "pi/2", "-3/4*pi", "inf", "0.25", "exp(1)": what may stand at the end of a range.
End parse_end(std::string text, bool closed, std::string_view whole) {
  std::erase(text, ' ');
  if (text == "inf" || text == "+inf") return {0, +1, false};
  if (text == "-inf") return {0, -1, false};
  GiNaC::symtab table;
  table["pi"] = GiNaC::Pi;
  try {
    constexpr std::size_t longest = 100;  // two numbers of 40 digits, a sign and π
    if (text.size() > longest || !is_constant(text)) throw std::invalid_argument("");
    const ex value = GiNaC::parser(table, true)(text);
    return {value, 0, closed};
  } catch (const std::exception&) {
    throw std::invalid_argument("cannot read the range '" + std::string(whole) +
                                "'; right is, for example, (0, pi/2)");
  }
}

}  // namespace

Interval overlap(const Interval& a, const Interval& b) {
  const int low = compare(a.low, b.low), high = compare(a.high, b.high);
  return {low == 0  ? (a.low.closed ? b.low : a.low)
          : low > 0 ? a.low
                    : b.low,
          high == 0  ? (a.high.closed ? b.high : a.high)
          : high < 0 ? a.high
                     : b.high};
}

Interval hull(const Interval& a, const Interval& b) {
  return {smaller(a.low, b.low), larger(a.high, b.high)};
}

Interval parse_range(std::string_view range) {
  thread_local std::map<std::string, Interval, std::less<>>
      known;  // the same few ranges are asked for all the time
  if (const auto found = known.find(range); found != known.end()) return found->second;
  const Range ends = read_range(range);
  const Interval interval{parse_end(ends.lower, ends.lower_closed, range),
                          parse_end(ends.upper, ends.upper_closed, range)};
  if (known.size() > 1000) known.clear();
  return known.emplace(range, interval).first->second;
}

Interval interval_of(const ex& expression, const Symbols& symbols) {
  try {
    return enclose(expression, symbols);
  } catch (const std::exception&) {  // a pole of GiNaC, or constants too close to tell: nothing is known
    return {};
  }
}

bool is_inside(const ex& point, const Interval& range, bool with_ends) {
  try {
    const int low = range.low.infinite != 0 ? 1 : compare(point, range.low.value),
              high = range.high.infinite != 0 ? 1 : compare(range.high.value, point);
    return (low > 0 || (with_ends && low == 0 && range.low.closed)) &&
           (high > 0 || (with_ends && high == 0 && range.high.closed));
  } catch (const std::exception&) {  // too close to tell
    return false;
  }
}

}  // namespace rederive
