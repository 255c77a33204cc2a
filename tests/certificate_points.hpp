// Looks at a certificate in points of its domain. Polynomials do not see which of its finitely many branches
// a root or an inverse function takes, nor what vanishes there; nineteen digits do.
#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <map>
#include <random>
#include <stdexcept>
#include <string>
#include <tests/certificate_functions.hpp>
#include <valarray>
#include <vector>

namespace certificate_checker {

inline void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

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
      if (!(std::abs(v.error[k]) <= 1e9L * (1 + std::abs(v.at[k])))) admitted_[k] = false;
  }
  void is_not_zero(const Seen& v, const std::string& message) {
    for (std::size_t k = 0; k < points; ++k)
      if (!(std::abs(v.at[k]) > 1e-15L * std::abs(v.error[k]))) wrong_[k] = message;
  }
  /// To six digits, of which the errors leave three; 0 is far from all other branches.
  void is_same(const Seen& a, const Seen& b, bool is_zero, const std::string& message) {
    for (std::size_t k = 0; k < points; ++k) {
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

}  // namespace certificate_checker
