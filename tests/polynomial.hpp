// Sparse polynomials over the exact integers and fractions of them: all that the certificate checker computes
// with.
#pragma once

#include <cln/cln.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace certificate_checker {

using Monomial = std::map<std::string, int>;  // powers by name
using Polynomial = std::map<Monomial, cln::cl_I>;
using Fraction = std::pair<Polynomial, Polynomial>;  // above and below

inline Polynomial plus(Polynomial a, const Polynomial& b) {
  for (const auto& [m, c] : b)
    if (cln::cl_I& sum = a.try_emplace(m, 0).first->second; cln::zerop(sum = sum + c)) a.erase(m);
  return a;
}
inline Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [m, c] : a)
    for (const auto& [n, d] : b) {
      Monomial both = m;
      for (const auto& [name, k] : n) both[name] += k;
      result = plus(std::move(result), {{both, c * d}});
    }
  return result;
}
inline Polynomial power(const Polynomial& a, int n) {
  return n == 0 ? Polynomial{{{}, 1}} : times(a, power(a, n - 1));
}
inline Fraction whole(const cln::cl_I& n) { return {plus({}, {{{}, n}}), {{{}, 1}}}; }
inline Fraction variable(const std::string& name) { return {{{{{name, 1}}, 1}}, {{{}, 1}}}; }
inline Fraction operator*(const Fraction& a, const Fraction& b) {
  return {times(a.first, b.first), times(a.second, b.second)};
}
inline Fraction operator/(const Fraction& a, const Fraction& b) { return a * Fraction{b.second, b.first}; }
inline Fraction operator+(const Fraction& a, const Fraction& b) {
  if (a.second == b.second) return {plus(a.first, b.first), a.second};
  return {plus(times(a.first, b.second), times(b.first, a.second)), times(a.second, b.second)};
}
inline Fraction operator-(const Fraction& a, const Fraction& b) { return a + whole(-1) * b; }
inline Fraction power(const Fraction& a, int n) {
  return n < 0 ? whole(1) / power(a, -n) : Fraction{power(a.first, n), power(a.second, n)};
}

/// Numerator and denominator of a fraction that is a number; else 0/0.
inline std::pair<int, int> ratio(const Fraction& f) {
  if (f.first.empty()) return {0, 1};
  if (f.second.empty() || f.first.rbegin()->first != Monomial{} || f.second.rbegin()->first != Monomial{})
    return {0, 0};
  const cln::cl_RA q = f.first.begin()->second / cln::cl_RA(f.second.begin()->second);
  return {cln::cl_I_to_int(cln::numerator(q)), cln::cl_I_to_int(cln::denominator(q))};
}

}  // namespace certificate_checker
