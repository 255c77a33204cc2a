// Sparse polynomials with exact coefficients, and fractions of them: all that the certificate checker
// computes with.
#pragma once

#include <cln/cln.h>

#include <map>
#include <stdexcept>
#include <string>

namespace certificate_checker {

using Number = cln::cl_RA;
using Monomial = std::map<std::string, int>;  // exponents, negative ones too
using Polynomial = std::map<Monomial, Number>;
struct Fraction {
  Polynomial above, below;
};

inline void require(bool condition, const std::string& what) {
  if (!condition) throw std::runtime_error(what);
}

inline Polynomial constant(const Number& n) { return cln::zerop(n) ? Polynomial{} : Polynomial{{{}, n}}; }
inline Polynomial variable(const std::string& name, int power = 1) {
  return power == 0 ? constant(1) : Polynomial{{{{name, power}}, 1}};
}
inline Polynomial plus(Polynomial a, const Polynomial& b, const Number& scale = 1) {
  for (const auto& [m, c] : b)
    if (Number& sum = a.try_emplace(m, 0).first->second; cln::zerop(sum = sum + scale * c)) a.erase(m);
  return a;
}
inline Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial product;
  for (const auto& [m, c] : a)
    for (const auto& [n, d] : b) {
      Monomial both = m;
      for (const auto& [name, power] : n)
        if ((both[name] += power) == 0) both.erase(name);
      if (Number& sum = product.try_emplace(both, 0).first->second; cln::zerop(sum = sum + c * d))
        product.erase(both);
    }
  return product;
}
inline Polynomial raised(const Polynomial& a, int n) {
  return n == 0 ? constant(1) : times(raised(a, n - 1), a);
}

inline Fraction fraction(const Polynomial& p) { return {p, constant(1)}; }
inline Fraction over(const Fraction& a, const Fraction& b) {
  Polynomial above = times(a.above, b.below), below = times(a.below, b.above);
  require(!below.empty(), "a division by zero");
  if (below.size() > 1) return {above, below};
  Monomial inverse;  // one term: it goes to the top
  for (const auto& [name, power] : below.begin()->first) inverse[name] = -power;
  return fraction(times(above, {{inverse, 1 / below.begin()->second}}));
}
inline Fraction product(const Fraction& a, const Fraction& b) {
  return {times(a.above, b.above), times(a.below, b.below)};
}
inline Fraction sum(const Fraction& a, const Fraction& b, int sign = 1) {
  if (a.below == b.below) return {plus(a.above, b.above, sign), a.below};
  return {plus(times(a.above, b.below), times(b.above, a.below), sign), times(a.below, b.below)};
}
inline Fraction power(const Fraction& a, int n) {
  return n < 0 ? over(fraction(constant(1)), power(a, -n)) : Fraction{raised(a.above, n), raised(a.below, n)};
}

/// The number that a fraction is, or nullptr.
inline const Number* number(const Fraction& f) {
  static const Number zero = 0;
  if (f.above.empty()) return &zero;
  return f.below == constant(1) && f.above.size() == 1 && f.above.begin()->first.empty()
             ? &f.above.begin()->second
             : nullptr;
}

}  // namespace certificate_checker
