// Sparse polynomials over the exact integers and fractions of them: all that the certificate checker computes
// with.
#pragma once

#include <cln/cln.h>

#include <map>
#include <string>
#include <utility>

namespace certificate_checker {

using Monomial = std::map<std::string, int>;  // powers by name
using Polynomial = std::map<Monomial, cln::cl_I>;
struct Fraction {
  Polynomial above, below;
};

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
  return {times(a.above, b.above), times(a.below, b.below)};
}
inline Fraction operator/(const Fraction& a, const Fraction& b) { return a * Fraction{b.below, b.above}; }
inline Fraction operator+(const Fraction& a, const Fraction& b) {
  if (a.below == b.below) return {plus(a.above, b.above), a.below};
  return {plus(times(a.above, b.below), times(b.above, a.below)), times(a.below, b.below)};
}

/// Numerator and denominator of a fraction that is a number; else 0/0.
inline std::pair<int, int> ratio(const Fraction& f) {
  if (f.above.empty()) return {0, 1};
  if (!f.above.rbegin()->first.empty() || f.below.empty() || !f.below.rbegin()->first.empty()) return {0, 0};
  const cln::cl_RA q = f.above.begin()->second / cln::cl_RA(f.below.begin()->second);
  return {cln::cl_I_to_int(cln::numerator(q)), cln::cl_I_to_int(cln::denominator(q))};
}

}  // namespace certificate_checker
