// Logarithms and the inverse circular functions.
#include <derivations/identity/translator.hpp>

namespace rederive {

using cln::cl_RA;
using Kind = Generator::Kind;

/// log of a positive value: the sum over its factors of known sign; what is left stays in one logarithm.
Fraction Translator::logarithm(const Fraction& value) {
  const Fraction u = ring_.normal(value);
  Fraction sum = 0;
  Polynomial rest = 1;
  for (const int side : {1, -1}) {
    const auto& [sign, list] = factors(side > 0 ? u.numerator : u.denominator);
    rest = sign * rest;
    for (const auto& [factor, exponent] : list) {
      const Signs signs = ring_.signs_of(factor);
      const bool has_sign = signs == Signs::positive() || signs == Signs::negative();
      // no factor is 0, so log f² = 2 log |f|; and n/d = n d / d²
      const int stays = has_sign ? 0 : exponent % 2, twice = side < 0 ? -2 * stays : 0,
                times = side * (exponent - stays) + twice;
      if (times != 0) sum = sum + times * logarithm_of(size_of(factor));
      if (stays != 0) rest = rest * factor;
      if (signs == Signs::negative() && exponent % 2 != 0) rest = -rest;
    }
  }
  if (rest.is_one()) return ring_.normal(sum);
  if (rest.is_constant()) throw NoValue("the logarithm of a negative number");
  return ring_.normal(sum + logarithm_of(rest));
}

/// log of a prime, or of a polynomial that is positive: what it is of an exponential or a root, else a
/// generator.
Fraction Translator::logarithm_of(const Polynomial& p) {
  const auto used = p.used();
  if (used.size() == 1 && p == Polynomial::variable(used[0])) {
    const Generator g = ring_.generators()[used[0]];
    if (g.kind == Kind::exponential) return g.of;
    if (g.kind == Kind::root) return logarithm(g.of) / Fraction(g.degree);
  }
  return ring_.function(Kind::logarithm, "log", p);
}

/// The argument itself, where asin undoes a sine or atan a tangent inside of its range.
std::optional<Fraction> Translator::inverted(bool is_sine, const Fraction& value) {
  const auto within = [&](const Fraction& x, int low, int high) {  // between these halves of π
    const Interval range = ring_.range_of(x);
    return compare(range.low, End{{0, cl_RA(low) / 2}}) >= 0 &&
           compare(range.high, End{{0, cl_RA(high) / 2}}) <= 0;
  };
  const auto is_zero = [&](const Fraction& f) { return ring_.normal(f).is_zero(); };
  for (const auto& [key, a] : arguments_) {
    if (is_zero(value * (is_sine ? Fraction(1) : a.cosine) - a.sine) && within(a.argument, -1, 1))
      return a.argument;
    if (is_zero(value * (is_sine ? Fraction(1) : a.sine) - a.cosine) && within(a.argument, 0, 2))
      return ring_.normal(pi() / 2 - a.argument);
  }
  return std::nullopt;
}

/// asin u, or atan u, as a generator; both are odd.
Fraction Translator::angle(bool is_sine, const Fraction& value) {
  const Fraction u = ring_.normal(value);
  if (u.is_zero()) return 0;
  if (const auto x = inverted(is_sine, u)) return *x;
  if (u.numerator.leads_with_minus()) return -angle(is_sine, -u);
  return ring_.function(Kind::angle, is_sine ? "asin" : "atan", u);
}

}  // namespace rederive
