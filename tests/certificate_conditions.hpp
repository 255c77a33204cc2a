// Looks at a certificate in points of its domain, and at ranges. Polynomials do not see which of its finitely
// many branches a root or an inverse function takes, nor what vanishes there; a hundred digits do.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <random>
#include <regex>
#include <tests/certificate_checker.hpp>
#include <tests/certificate_ranges.hpp>

namespace certificate_checker {

constexpr std::size_t points = 50;
constexpr long digits = 100;
inline cln::cl_R ten_to(long n) { return cln::expt(cln::cl_RA(10), n); }
inline cln::cl_F rounded(const cln::cl_R& x) { return cln::cl_float(x, cln::float_format(digits)); }

/// As large as |z|, within a factor of two, in few digits.
inline cln::cl_R size_of(const cln::cl_N& z) {
  const cln::float_format_t few = cln::float_format(17);
  return cln::cl_float(cln::abs(cln::realpart(z)), few) + cln::cl_float(cln::abs(cln::imagpart(z)), few);
}
/// A value, and by how many units of the last place of 1 it may be wrong, for a sum that cancels is much
/// larger than its value; or none.
struct Number {
  cln::cl_N at = 0;
  cln::cl_R error = 0;
  bool is_known = false;
  cln::cl_R size() const { return size_of(at); }
  /// As far as its error lets it be told.
  bool is_zero() const { return size() <= ten_to(5 - digits) * error; }
  bool is_real() const { return cln::abs(cln::imagpart(at)) <= ten_to(5 - digits) * error; }
};
inline Number known(const cln::cl_N& at) { return {at, size_of(at), true}; }
inline Number operator+(const Number& a, const Number& b) {
  return {a.at + b.at, a.error + b.error, a.is_known && b.is_known};
}
inline Number operator*(const Number& a, const Number& b) {
  return {a.at * b.at, a.error * b.size() + a.size() * b.error, a.is_known && b.is_known};
}
inline Number operator/(const Number& a, const Number& b) {
  if (!b.is_known || b.is_zero()) return {};
  const cln::cl_N at = a.at / b.at;
  return {at, (a.error + size_of(at) * b.error) / b.size(), a.is_known};
}

/// What is seen of a value: the numbers, one for each point; and its range, as its form shows it.
struct Seen {
  std::vector<Number> at;
  Range range;
};
template <class Operation>
Seen combined(const Seen& a, const Seen& b, const Operation& operation) {
  Seen result{a.at, operation(a.range, b.range)};
  for (std::size_t k = 0; k < points; ++k) result.at[k] = operation(a.at[k], b.at[k]);
  return result;
}
inline Seen operator+(const Seen& a, const Seen& b) { return combined(a, b, std::plus<>()); }
inline Seen operator*(const Seen& a, const Seen& b) { return combined(a, b, std::multiplies<>()); }
inline Seen operator/(const Seen& a, const Seen& b) { return combined(a, b, std::divides<>()); }

/// A power of e; of a root "^p/q" or an inverse function the principal value, none where it is not real.
inline cln::cl_N principal_value(const std::string& function, const cln::cl_N& x) {
  using N = const cln::cl_N&;
  static const std::map<std::string, cln::cl_N (*)(N)> functions{
      {"log", [](N z) { return cln::log(z); }},     {"asin", [](N z) { return cln::asin(z); }},
      {"acos", [](N z) { return cln::acos(z); }},   {"atan", [](N z) { return cln::atan(z); }},
      {"asinh", [](N z) { return cln::asinh(z); }}, {"acosh", [](N z) { return cln::acosh(z); }},
      {"atanh", [](N z) { return cln::atanh(z); }}, {"exp", [](N z) { return cln::exp(z); }}};
  if (function == "exp") return functions.at(function)(x);
  const auto power = [&](const cln::cl_RA& q) -> cln::cl_N {
    return cln::zerop(x) && cln::plusp(q) ? x : cln::exp(q * cln::log(x));
  };
  const cln::cl_N z =
      function[0] != '^' ? functions.at(function)(x) : power(cln::cl_RA(function.substr(1).c_str()));
  require(cln::abs(cln::imagpart(z)) <= size_of(z) * ten_to(-digits / 2), "not real");
  return cln::realpart(z);
}
/// With the error that the function makes of that of its argument, on a side where it has a value.
inline Number value_of(const std::string& function, const Number& x) {
  const cln::cl_R part = ten_to(-digits / 2);
  for (const int side : {1, -1}) try {
      if (!x.is_known) return x;
      const cln::cl_N at = principal_value(function, x.at),
                      beside = principal_value(function, x.at + side * rounded(x.error * part));
      return {at, size_of(at) + size_of(beside - at) / part, true};
    } catch (const std::exception&) {  // a pole, a number that is too large, or not real
    }
  return {};
}
inline Seen seen(const std::string& function, Seen x) {
  for (Number& number : x.at) number = value_of(function, number);
  return {x.at, {}};
}
inline Seen seen(const cln::cl_N& everywhere, const Range& range) {
  return {std::vector<Number>(points, known(everywhere)), range};
}

/// What was found wrong at each point, and whether the statement has a value there.
class Looks {
 public:
  void admit(const Seen& v) {
    for (std::size_t k = 0; k < points; ++k)
      admitted_[k] =
          admitted_[k] && v.at[k].is_known && v.at[k].error <= ten_to(digits / 2) * (1 + v.at[k].size());
  }
  /// Between these ends.
  void admit(const Seen& v, const std::optional<cln::cl_R>& low, const std::optional<cln::cl_R>& high) {
    for (std::size_t k = 0; k < points; ++k) {
      const cln::cl_R at = cln::realpart(v.at[k].at);
      if ((low && at < *low) || (high && at > *high)) admitted_[k] = false;
    }
  }
  bool is_admitted(std::size_t point) const { return admitted_[point]; }
  bool is_any_admitted() const {
    return std::find(admitted_.begin(), admitted_.end(), true) != admitted_.end();
  }
  void is_not_zero(const Seen& v, const std::string& message) {
    for (std::size_t k = 0; k < points; ++k)
      if (!v.at[k].is_known || v.at[k].is_zero()) wrong_[k] = message;
  }
  /// To six digits, of which the errors leave three; 0 is far from all other branches.
  void is_same(const Seen& a, const Seen& b, const std::string& message) {
    for (std::size_t k = 0; k < points; ++k) {
      const Number &x = a.at[k], &y = b.at[k];
      const bool is_zero = cln::zerop(x.at) && cln::zerop(x.error);
      const cln::cl_R most = ten_to(-6) * (is_zero ? 1 : y.size());
      if (!x.is_known || !y.is_known || size_of(x.at - y.at) > most ||
          (!is_zero && (x.error + y.error) * ten_to(-digits) > most))
        wrong_[k] = message;
    }
  }
  /// Throws where anything is wrong at a point that is admitted, or where no point is.
  void report() const {
    for (std::size_t k = 0; k < points; ++k) require(!admitted_[k] || wrong_[k].empty(), wrong_[k]);
    require(is_any_admitted(), "it has a value nowhere");
  }

 private:
  std::vector<std::string> wrong_ = std::vector<std::string>(points);
  std::vector<bool> admitted_ = std::vector<bool>(points, true);
};

/// Numbers between two ends, if it has them: all over, near one, and near the other.
inline std::vector<Number> drawn(const std::optional<cln::cl_R>& low, const std::optional<cln::cl_R>& high,
                                 std::mt19937& random) {
  std::vector<Number> result(points);
  for (std::size_t k = 0; k < points; ++k) {
    const int width = std::array{1, 3, 10}[k % 3];
    const cln::cl_RA even = (2 * cln::cl_RA(random()) + 1) / cln::expt(cln::cl_RA(2), 33),
                     near = cln::expt(even, 4);
    const cln::cl_R share = std::array{even, near, 1 - near}[low && high ? random() % 3 : 0];
    const cln::cl_R from = low    ? *low
                           : high ? *high - width
                                  : cln::cl_R(-width),
                    to = high  ? *high
                         : low ? *low + width
                               : cln::cl_R(width);
    result[k] = known(rounded(from + (to - from) * share));
  }
  return result;
}

/// Reads texts into what is seen of them.
class Look : public Reader<Seen> {
 public:
  Look() {
    names_["$i"] = seen(cln::complex(0, 1), {});
    names_["pi"] = seen(cln::pi(cln::float_format(digits)), point(turned(1)));
  }
  /// A name that lives in a range such as "(0, pi/2]"; with points of one side of 0, too: < or >.
  void draw(const std::string& name, const std::string& range, char side) {
    Bounds bounds = read_bounds(range);
    const bool has_zero =
        (!bounds.low || cln::minusp(*bounds.low)) && (!bounds.high || cln::plusp(*bounds.high));
    require(side == ' ' || has_zero, "cut at 0, which is not in it: " + range);
    if (side != ' ') (side == '>' ? bounds.low : bounds.high) = 0;
    names_[name] = {drawn(bounds.low, bounds.high, random_), bounds.whole};
  }
  void name(const std::string& name, const std::string& text) { names_[name] = value(text); }
  /// Of which only the points count where it is in its range; that, as far as it is known.
  Range narrow(const std::string& name, const std::string& range) {
    const Bounds bounds = read_bounds(range);
    looks_.admit(names_[name], bounds.low, bounds.high);
    return names_[name].range = both(names_[name].range, bounds.whole);
  }
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
  /// With another range of a name: that of a text, if it certainly has a value all over it.
  std::optional<Range> whole_range(const std::string& text, const std::string& name, const Range& range) {
    const Range before = std::exchange(names_.at(name).range, range);
    is_whole_ = divisors_are_clear = true;
    const Range result = value(text).range;
    names_.at(name).range = before;
    return is_whole_ && divisors_are_clear ? std::optional(result) : std::nullopt;
  }
  Range range(const std::string& name) const { return names_.at(name).range; }
  bool is_admitted(std::size_t point) const { return looks_.is_admitted(point); }
  bool is_any_admitted() const { return looks_.is_any_admitted(); }
  void report() const { looks_.report(); }
  bool divisors_are_clear = true;  ///< the ranges of all that was read show that it is not 0
  std::vector<bool> roots_exist;   ///< of all that was read, in its order, whether a range shows that

 private:
  struct Bounds {
    Range whole;
    std::optional<cln::cl_R> low, high;
  };
  Bounds read_bounds(const std::string& range) {
    static const std::regex form("[[(][^,]+, [^,]+[\\])]");
    require(range.size() < 1000 && std::regex_match(range, form), "no range: " + range);
    const std::size_t comma = range.find(',');
    const std::string from = range.substr(1, comma - 1),
                      to = range.substr(comma + 2, range.size() - comma - 3);
    Bounds b{{least, most, range.front() == '[', range.back() == ']'}, {}, {}};
    if (from != "-inf") b.whole.low = value(from).range.low, b.low = cln::realpart(value(from).at[0].at);
    if (to != "inf") b.whole.high = value(to).range.high, b.high = cln::realpart(value(to).at[0].at);
    return b;
  }
  Seen number(const cln::cl_I& n) const override { return seen(rounded(n), point({n})); }
  /// Ranges are those where there is a value, and there it is not 0.
  Seen divisor(const Seen& d) override {
    looks_.is_not_zero(d, "a divisor is 0");
    divisors_are_clear = divisors_are_clear && (d.range.is_positive() || d.range.is_negative());
    return {d.at, without_zero(d.range)};
  }
  Seen raised(const Seen& base, const Seen& exponent) override {
    const cln::cl_RA n = exponent.range.is_constant() ? exponent.range.low.number : 0;
    const auto text = [](const cln::cl_I& i) { return std::to_string(cln::cl_I_to_long(i)); };
    if (exponent.range.is_constant() && cln::denominator(n) == 1) {
      Seen result = power(cln::minusp(n) ? divisor(base) : base, cln::cl_I_to_long(cln::numerator(n)));
      if (cln::evenp(cln::numerator(n)))
        result.range = not_negative(result.range);
      else if (cln::plusp(n))
        result.range = both(result.range, odd_power_of(n, base.range));
      return result;
    }
    if (!exponent.range.is_constant()) return call("exp", exponent * call("log", base));
    roots_exist.push_back(cln::minusp(n) ? base.range.is_positive() : base.range.is_not_negative());
    is_whole_ = is_whole_ && roots_exist.back();
    Seen root = seen("^" + text(cln::numerator(n)) + "/" + text(cln::denominator(n)), base);
    root.range = power_of(n, base.range);
    return root;
  }
  Seen call(const std::string& f, const Seen& x) override {
    is_whole_ = is_whole_ && is_defined(f, x.range);
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
  bool is_whole_ = true;  ///< no function that was read is known to have no value somewhere
};

}  // namespace certificate_checker
