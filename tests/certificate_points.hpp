// Points to look at a certificate: numbers drawn from ranges, and the functions there. Polynomials do not see
// which of its finitely many branches a root or an inverse function takes; nineteen digits do.
#pragma once

#include <complex>
#include <map>
#include <random>
#include <string>
#include <valarray>

namespace certificate_checker {

using Number = std::complex<long double>;
using Numbers = std::valarray<Number>;  // one for each point
constexpr std::size_t points = 200;

/// Numbers between two ends, which may be infinite.
inline Numbers drawn(long double low, long double high, std::mt19937& random) {
  Numbers result(points);
  for (std::size_t k = 0; k < points; ++k) {
    const long double width = k % 2 == 0 ? 3 : 1, share = (random() + 0.5L) / 4294967296.0L;
    const long double from = std::isfinite(low) ? low : std::isfinite(high) ? high - width : -width;
    const long double to = std::isfinite(high) ? high : std::isfinite(low) ? low + width : width;
    result[k] = from + (to - from) * share;
  }
  return result;
}

inline Numbers sizes(const Numbers& numbers) {
  return numbers.apply([](const Number& z) -> Number { return std::abs(z); });
}
/// A power of e, of a root "^p/q" or of an inverse function the principal value; not a number where that is
/// not real.
inline Numbers principal_values(const std::string& function, const Numbers& x) {
  using F = Number (*)(const Number&);
  static const std::map<std::string, F> functions{
      {"log", std::log},     {"asin", std::asin},   {"acos", std::acos},   {"atan", std::atan},
      {"asinh", std::asinh}, {"acosh", std::acosh}, {"atanh", std::atanh}, {"exp", std::exp}};
  if (function == "exp") return x.apply(functions.at(function));
  Numbers values = x;
  if (function[0] == '^') {
    const auto bar = function.find('/');
    const Number exponent = std::stold(function.substr(1)) / std::stold(function.substr(bar + 1));
    for (Number& z : values) z = std::pow(z, exponent);
  } else {
    values = x.apply(functions.at(function));
  }
  return values.apply([](const Number& z) -> Number {
    return std::abs(z.imag()) <= 1e-9L * (1 + std::abs(z)) ? z : Number(std::nanl(""));
  });
}

}  // namespace certificate_checker
