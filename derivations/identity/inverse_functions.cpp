// Logarithms and the inverse circular functions.
#include <derivations/identity/translator.hpp>

namespace rederive {

using cln::cl_RA;
using Kind = Generator::Kind;

/// log of a positive value: the sum over its factors of known sign; what is left stays in one logarithm.
Fraction Translator::logarithm(const Fraction& value) {
  const Fraction u = ring_.normal(value);
  Fraction sum = 0;
  Polynomial rest_above = 1, rest_below = 1;
  Signs outside = Signs::positive();
  for (const int side : {1, -1}) {
    const Polynomial& p = side > 0 ? u.numerator : u.denominator;
    const auto& [number, list] = factors(p);
    if (cln::minusp(number)) outside = -outside;
    if (cln::abs(number) != 1) sum = sum + side * logarithm_of(Polynomial(cln::abs(number)));
    for (const auto& [factor, exponent] : list) {
      const Signs signs = ring_.signs_of(factor);
      if (signs == Signs::positive() || signs == Signs::negative()) {
        if (exponent % 2 != 0) outside = outside * signs;
        sum = sum + side * exponent * logarithm_of(signs == Signs::positive() ? factor : -factor);
        continue;
      }
      Polynomial& rest = side > 0 ? rest_above : rest_below;
      const int odd = exponent % 2;  // no factor is 0, so log f² = 2 log |f|
      if (exponent > 1) sum = sum + side * (exponent - odd) * logarithm(absolute(factor));
      if (odd != 0) rest = rest * factor;
    }
  }
  if (rest_above.is_one() && rest_below.is_one()) {
    if (outside == Signs::negative()) throw NoValue("the logarithm of a negative number");
    return ring_.normal(sum);
  }
  const Polynomial rest = outside == Signs::negative() ? -(rest_above * rest_below) : rest_above * rest_below;
  if (!rest_below.is_one()) sum = sum - 2 * logarithm(absolute(rest_below));  // n/d = n d / d²
  return ring_.normal(sum + logarithm_of(rest));
}

/// log of a polynomial that is positive: what it is of an exponential or a root, else a generator.
Fraction Translator::logarithm_of(const Polynomial& p) {
  if (p.is_constant()) {  // prime by prime
    cln::cl_I rest = p.constant();
    Fraction sum = 0;
    for (cln::cl_I prime = 2; prime * prime <= rest && prime < 2000; prime = prime + 1)
      while (cln::zerop(cln::mod(rest, prime)) && prime != rest) {
        rest = cln::exquo(rest, prime);
        sum = sum + logarithm_of(Polynomial(prime));
      }
    if (rest == 1) return sum;
    if (rest != p.constant()) return sum + logarithm_of(Polynomial(rest));
  }
  const auto used = p.used();
  if (used.size() == 1 && p == Polynomial::variable(used[0])) {
    const Generator g = ring_.generators()[used[0]];
    if (g.kind == Kind::exponential) return g.of;
    if (g.kind == Kind::root) return logarithm(g.of) / Fraction(g.order);
  }
  return ring_.generator("log " + p.key(), [&] {
    Generator g;
    g.kind = Kind::logarithm, g.of = p, g.meaning = GiNaC::log(ring_.meaning_of(p));
    g.range = rederive::call("log", overlap(ring_.range_of(Fraction(p)), positive_numbers()));
    return g;
  });
}

/// cos and sin of asin u and atan u.
std::pair<Fraction, Fraction> Translator::circular_of_angle(const Generator& angle) {
  const Fraction u = angle.of;
  if (angle.order == 1) return {root(1 - u * u, 2), u};
  const Fraction hypotenuse = root(1 + u * u, 2);
  return {ring_.normal(1 / hypotenuse), ring_.normal(u / hypotenuse)};
}

/// The argument itself, where asin undoes a sine or atan a tangent inside of its range.
std::optional<Fraction> Translator::inverted(bool is_sine, const Fraction& value) {
  const auto within = [&](const Fraction& x, int low, int high) {  // between these halves of π
    const Interval range = ring_.range_of(x);
    return compare(range.low, End{{0, cl_RA(low) / 2}}) >= 0 &&
           compare(range.high, End{{0, cl_RA(high) / 2}}) <= 0;
  };
  for (const auto& [key, a] : std::map<std::string, Argument>(arguments_)) {
    const auto is_zero = [&](const Fraction& f) { return ring_.normal(f).is_zero(); };
    if (is_zero(value * (is_sine ? Fraction(1) : a.cosine) - a.sine) && within(a.argument, -1, 1))
      return a.argument;
    if (is_zero(value * (is_sine ? Fraction(1) : a.sine) - a.cosine) && within(a.argument, 0, 2))
      return ring_.normal(pi() / 2 - a.argument);
  }
  const Interval range = rederive::call(is_sine ? "asin" : "atan", ring_.range_of(value));
  std::vector<cl_RA> turns;  // the multiples of π/12 that it may be
  for (int k = -6; k <= 6; ++k)
    if (range.contains({0, cl_RA(k) / 12})) turns.push_back(cl_RA(k) / 12);
  if (turns.size() == 1) {
    const auto [c, s] = turn(turns[0]);
    if (ring_.normal(value * (is_sine ? Fraction(1) : c) - s).is_zero()) return pi() * Fraction(turns[0]);
  }
  return std::nullopt;
}

/// asin u, or atan u, as a generator; both are odd.
Fraction Translator::angle(bool is_sine, const Fraction& value) {
  const Fraction u = ring_.normal(value);
  if (u.is_zero()) return 0;
  if (const auto x = inverted(is_sine, u)) return *x;
  if (u.numerator.leads_with_minus()) return -angle(is_sine, -u);
  return ring_.generator((is_sine ? "asin " : "atan ") + u.key(), [&] {
    Generator g;
    const GiNaC::ex meaning = ring_.meaning_of(u);
    g.kind = Kind::angle, g.of = u, g.order = is_sine ? 1 : 2;
    g.meaning = is_sine ? GiNaC::asin(meaning) : GiNaC::atan(meaning);
    g.range = rederive::call(is_sine ? "asin" : "atan", ring_.range_of(u));
    return g;
  });
}

}  // namespace rederive
