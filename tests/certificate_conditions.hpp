// Looks at a certificate in points of its domain, and at ranges. Polynomials do not see which of its finitely
// many branches a root or an inverse function takes, nor what vanishes there; nineteen digits do.
#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <random>
#include <tests/certificate_checker.hpp>
#include <tests/certificate_ranges.hpp>
#include <valarray>

namespace certificate_checker {

using Number = std::complex<long double>;
using Numbers = std::valarray<Number>;  // one for each point
constexpr std::size_t points = 100;

inline Numbers sizes(const Numbers& numbers) {
  return numbers.apply([](const Number& z) -> Number { return std::abs(z); });
}

/// What is seen of a value: the numbers, and by how many units of the last place of 1 they may be wrong, for
/// a sum that cancels is much larger than its value; and its range, as its form shows it.
struct Seen {
  Numbers at, error;
  Range range;
};
inline Seen seen(const Numbers& at, Range range) { return {at, sizes(at), range}; }
inline Seen operator+(const Seen& a, const Seen& b) {
  return {a.at + b.at, a.error + b.error, a.range + b.range};
}
inline Seen operator*(const Seen& a, const Seen& b) {
  return {a.at * b.at, a.error * sizes(b.at) + sizes(a.at) * b.error, a.range * b.range};
}
inline Seen operator/(const Seen& a, const Seen& b) {
  const Numbers at = a.at / b.at;
  return {at, (a.error + sizes(at) * b.error) / sizes(b.at), a.range / b.range};
}

/// A power of e; of a root "^p/q" or an inverse function the principal value, not a number where it is not
/// real.
inline Numbers principal_values(const std::string& function, const Numbers& x) {
  using F = Number (*)(const Number&);
  static const std::map<std::string, F> functions{
      {"log", std::log},     {"asin", std::asin},   {"acos", std::acos},   {"atan", std::atan},
      {"asinh", std::asinh}, {"acosh", std::acosh}, {"atanh", std::atanh}, {"exp", std::exp}};
  if (function == "exp") return x.apply(functions.at(function));
  Numbers values = x;
  const auto bar = function.find('/');
  for (Number& z : values)
    z = function[0] != '^'
            ? functions.at(function)(z)
            : std::pow(z, std::stold(function.substr(1)) / std::stold(function.substr(bar + 1)));
  return values.apply([](const Number& z) -> Number {
    return std::abs(z.imag()) <= 1e-12L * std::abs(z) ? z.real() : std::nanl("");
  });
}
/// With the error that the function makes of that of its argument.
inline Seen seen(const std::string& function, const Seen& x) {
  constexpr long double part = 1e-12L;
  const Numbers at = principal_values(function, x.at),
                beside = principal_values(function, x.at + x.error * Number(part));
  return {at, sizes(at) + sizes(beside - at) / Number(part), {}};
}

/// What was found wrong at each point, and whether the statement has a value there.
class Looks {
 public:
  void admit(const Seen& v) {
    for (std::size_t k = 0; k < points; ++k)
      if (const long double error = std::abs(v.error[k]);
          !std::isfinite(error) || error > 1e9L * (1 + std::abs(v.at[k])))
        admitted_[k] = false;
  }
  void is_not_zero(const Seen& v, const std::string& message) {
    for (std::size_t k = 0; k < points; ++k)
      if (!(std::abs(v.at[k]) > 1e-15L * std::abs(v.error[k]))) wrong_[k] = message;
  }
  /// To six digits, of which the errors leave three; 0 is far from all other branches.
  void is_same(const Seen& a, const Seen& b, const std::string& message) {
    for (std::size_t k = 0; k < points; ++k) {
      const bool is_zero = a.at[k] == Number(0) && a.error[k] == Number(0);
      const long double size = is_zero ? 1 : std::abs(b.at[k]), error = std::abs(a.error[k] + b.error[k]);
      if (!(std::abs(a.at[k] - b.at[k]) <= 1e-6L * size) || !(is_zero || error * 1e-19L <= 1e-6L * size))
        wrong_[k] = message;
    }
  }
  /// Throws where anything is wrong at a point that is admitted, or where no point is.
  void report() const {
    for (std::size_t k = 0; k < points; ++k) require(!admitted_[k] || wrong_[k].empty(), wrong_[k]);
    require(std::find(admitted_.begin(), admitted_.end(), true) != admitted_.end(), "it has a value nowhere");
  }

 private:
  std::vector<std::string> wrong_ = std::vector<std::string>(points);
  std::vector<bool> admitted_ = std::vector<bool>(points, true);
};

/// Numbers between two ends, which may be infinite.
inline Numbers drawn(long double low, long double high, std::mt19937& random) {
  Numbers result(points);
  for (std::size_t k = 0; k < points; ++k) {
    const long double width = std::array{1, 3, 10}[k % 3], share = (random() + 0.5L) / 4294967296.0L;
    const long double from = std::isfinite(low) ? low : std::isfinite(high) ? high - width : -width;
    const long double to = std::isfinite(high) ? high : std::isfinite(low) ? low + width : width;
    result[k] = from + (to - from) * share;
  }
  return result;
}

/// Reads texts into what is seen of them.
class Look : public Reader<Seen> {
 public:
  Look() {
    names_["$i"] = seen(Numbers(Number(0, 1), points), {});
    names_["pi"] = seen(Numbers(std::numbers::pi_v<long double>, points), turned(1, 1, true));
  }
  /// A name that lives in a range such as "(0, pi/2]"; with points of one side of 0, too: < or >.
  void draw(const std::string& name, const std::string& range, char side) {
    const std::size_t comma = range.find(',');
    const auto end = [&](const std::string& s) -> Seen {
      const long double infinite = s == "inf" ? INFINITY : -INFINITY;
      return s.ends_with("inf") ? seen(Numbers(infinite, points), {infinite, infinite}) : value(s);
    };
    const Seen from = end(range.substr(1, comma - 1)),
               to = end(range.substr(comma + 2, range.size() - comma - 3));
    const Range whole{from.range.low,      to.range.high,        range.front() == '[',
                      range.back() == ']', from.range.exact_low, to.range.exact_high};
    const long double low = side == '>' ? 0 : from.at[0].real(), high = side == '<' ? 0 : to.at[0].real();
    names_[name] = seen(drawn(low, high, random_), whole);
  }
  void name(const std::string& name, const std::string& text) { names_[name] = value(text); }
  /// The step takes the principal branch.
  void take(const Json& step) {
    const bool is_named = step.contains("name");
    const std::string f = step.at("function"), text = step.at(is_named ? "name" : "is");
    const Seen of = value(step.at("of"));
    value("1/(" + step.value("cofactor", "1") + ")");
    if (is_named) names_[text] = seen(f, of);
    const Seen is = value(text), exponent = f == "log" || f.ends_with('h') ? is : value("$i") * is;
    if (step.contains("unit"))
      looks_.is_same(value(step.at("unit")), seen("exp", exponent), "another branch of exp");
    looks_.is_same(is, seen(f, of), "another branch of " + f);
  }
  /// Where the statement has a value.
  void admit(const std::string& text) { looks_.admit(value(text)); }
  void report() const { looks_.report(); }
  bool divisors_are_clear = true;  ///< the ranges of all that was read show that it is not 0

 private:
  Seen number(const cln::cl_I& n) override {
    return seen(Numbers(static_cast<long double>(cln::double_approx(n)), points), point(n));
  }
  /// Ranges are those where there is a value, and there it is not 0.
  Seen divisor(const Seen& d) override {
    looks_.is_not_zero(d, "a divisor vanishes");
    divisors_are_clear = divisors_are_clear && (d.range.is_positive() || d.range.is_negative());
    Seen result = d;
    if (d.range.low == 0) result.range.has_low = false;
    if (d.range.high == 0) result.range.has_high = false;
    return result;
  }
  Seen raised(const Seen& base, const Seen& exponent) override {
    const cln::cl_RA n = exponent.range.is_constant() ? exponent.range.exact_low.number : 0;
    const auto text = [](const cln::cl_I& i) { return std::to_string(cln::cl_I_to_long(i)); };
    if (exponent.range.is_constant() && cln::denominator(n) == 1) {
      Seen result = power(cln::minusp(n) ? divisor(base) : base, cln::cl_I_to_long(cln::numerator(n)));
      if (cln::evenp(cln::numerator(n))) result.range = not_negative(result.range);
      return result;
    }
    Seen root = exponent.range.is_constant()
                    ? seen("^" + text(cln::numerator(n)) + "/" + text(cln::denominator(n)), base)
                    : seen("exp", exponent * call("log", base));
    root.range = {0, INFINITY, !base.range.is_positive(), false};
    return root;
  }
  Seen call(const std::string& f, const Seen& x) override {
    if (!meanings.contains(f)) return with_range(f, x, seen(f, x));
    names_["#u"] = seen("exp", f.ends_with('h') ? x : names_["$i"] * x);
    names_["#v"] = number(1) / names_["#u"];
    names_["#x"] = x;
    return with_range(f, x, value(meanings.at(f)));
  }
  static Seen with_range(const std::string& f, const Seen& x, Seen result) {
    result.range = range_of(f, x.range, result.range);
    return result;
  }

  std::mt19937 random_;
  Looks looks_;
};

}  // namespace certificate_checker
