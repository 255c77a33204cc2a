// Roots, absolute values, logarithms and the inverse circular functions. A factor that is never negative
// leaves a root or an absolute value, and a factor of known sign leaves a logarithm.
#include <derivations/identity/translator.hpp>

namespace rederive::identity {
using namespace language;
using namespace numbers;

/// Returns y >= 0 with y^order = base: a power of the generator that all roots of this base share.
Fraction Translator::root_generator(const Polynomial& base, int order) {
  const int part = base == 2 ? 4 : base == 3 ? 6 : 0;  // √2 = 2 cos π/4, √3 = 2 cos π/6
  if (order == 2 && part != 0 && cln::zerop(cln::mod(denominators_.at({"turn", 0}), part)))
    return 2 * circular(pi() / part).first;
  const int common = common_multiple("root", base, order);
  const Fraction y = ring_.generator("root " + std::to_string(common), base, [&] {
    const GiNaC::ex meaning = pow(ring_.meaning_of(base), GiNaC::numeric(1, common));
    const Interval range = numbers::power(ring_.range_of(Fraction(base)), cln::cl_RA(1) / common);
    return Generator{meaning, range, "sqrt", base, common, base};
  });
  return power(y, common / order);
}

Fraction Translator::root(const Fraction& value, int order) {
  const Fraction u = ring_.normal(value);
  if (u.is_zero()) return 0;
  // (n/d)^{1/k} = (n d^{km-1})^{1/k} / |d|^m for even km, because n d^{km-1} has the sign of n/d
  const int m = order % 2 == 0 ? 1 : 2;
  const auto& [sign, list] = factors(u.numerator * power(u.denominator, order * m - 1));
  Signs of_odd = sign < 0 ? Signs::negative() : Signs::positive();
  for (const auto& [factor, exponent] : list)
    if (exponent % 2 != 0) of_odd = of_odd * ring_.signs_of(factor);
  if (of_odd == Signs::zero()) return 0;
  Fraction outside = 1 / (m == 1 ? absolute(u.denominator) : Fraction(u.denominator * u.denominator));
  Polynomial inside = sign;
  for (const auto& [factor, exponent] : list) {
    const Signs signs = ring_.signs_of(factor);
    const bool is_negative = signs.within(Signs::nonpositive()),
               has_sign = is_negative || signs.within(Signs::nonnegative());
    // a factor that may be 0 stays beside one that may be negative: where it is 0, the rest may have no root
    const bool comes_out = of_odd.within(Signs::nonnegative()) || signs.is_definite();
    const int taken = !comes_out ? 0 : has_sign ? exponent : exponent - exponent % 2;
    if (is_negative && taken % 2 != 0) inside = -inside;
    inside = inside * power(factor, exponent - taken);
    if (taken > 0) outside = outside * Fraction(power(modulus(factor), taken / order));
    if (taken % order != 0) outside = outside * power(root_generator(modulus(factor), order), taken % order);
  }
  if (inside.is_one()) return ring_.normal(outside);
  if (inside.is_constant()) throw NoValue("a root of a negative number");
  return ring_.normal(outside * root_generator(inside, order));
}

/// Returns base^exponent for a fraction: (t^{2n})^q = |t|^{2nq}, before anything is multiplied out.
Fraction Translator::root_of(const Tree& tree, const Fraction& base, const cln::cl_RA& exponent) {
  const bool is_power = tree->kind == Node::Kind::power && tree->children[1]->kind == Node::Kind::number;
  const cln::cl_RA inner = is_power ? exact(tree->children[1]->text) : cln::cl_RA(1);
  if (cln::denominator(inner / 2) != 1) return raised(base, exponent);
  return raised(absolute(translate(tree->children[0])), inner * exponent);
}

/// Returns the absolute value of an irreducible polynomial, without bars if its sign is known.
Polynomial Translator::modulus(const Polynomial& factor) {
  const Signs signs = ring_.signs_of(factor);
  if (signs.within(Signs::nonnegative())) return factor;
  if (signs.within(Signs::nonpositive())) return -factor;
  return ring_.function("fabs", factor, 2, factor * factor).numerator;
}

/// Returns |n/d| = |n d|/d², factor by factor.
Fraction Translator::absolute(const Fraction& value) {
  const Fraction u = ring_.normal(value);
  const auto& [sign, list] = factors(u.numerator * u.denominator);
  Polynomial size = std::abs(sign);
  for (const auto& [factor, exponent] : list)
    size = size * power(exponent % 2 == 0 ? factor : modulus(factor), exponent);
  return ring_.normal(Fraction(size, u.denominator * u.denominator));
}

/// Returns log of a positive value: a sum over its factors of known sign, and one logarithm of the rest.
Fraction Translator::logarithm(const Fraction& value) {
  const Fraction u = ring_.normal(value);
  const auto& [sign, list] = factors(u.numerator * u.denominator);  // n/d = n d / d²
  Fraction sum = 0;
  Polynomial rest = sign;
  for (const auto& [factor, exponent] : list) {
    const Signs signs = ring_.signs_of(factor);
    const bool has_sign = signs == Signs::positive() || signs == Signs::negative();
    const int stays = has_sign ? 0 : exponent % 2,  // no factor is 0, so log f² = 2 log |f|
        squares = quotient(u.denominator, factor) ? 2 * exponent : 0, times = exponent - stays - squares;
    if (times != 0) sum = sum + times * logarithm_of(modulus(factor));
    if (stays != 0) rest = rest * factor;
    if (signs == Signs::negative() && exponent % 2 != 0) rest = -rest;
  }
  if (rest.is_one()) return ring_.normal(sum);
  if (rest.is_constant()) throw NoValue("a logarithm of a negative number");
  return ring_.normal(sum + logarithm_of(rest));
}

/// Returns log of a prime or of a positive polynomial; for an exponential or a root it is known.
Fraction Translator::logarithm_of(const Polynomial& p) {
  const auto used = p.used();
  if (used.size() == 1 && p == Polynomial::variable(used[0])) {
    const Generator g = ring_.generators()[used[0]];
    if (g.function == "exp") return g.of;
    if (g.function == "sqrt") return logarithm(g.of) / Fraction(g.degree);
  }
  return ring_.function("log", p);
}

/// Returns a - k·π for the integer k that provably moves it between -π/2 and π/2; times (-1)^k for the sine.
std::optional<Fraction> Translator::moved_by_half_turns(const Fraction& a, bool is_sine) {
  Interval range = point({});
  Ball twice(0, 128);  // the middle, of the terms that are bounded
  for (const auto& [number, term] : terms_of(a)) {
    const auto [low, high] = ring_.range_of(term) * point({number});
    range = range + Interval{low, high};
    if (low.infinite == 0 && high.infinite == 0) twice = twice + low.ball(128) + high.ball(128);
  }
  const cln::cl_I nearest = cln::round1((twice / (Ball(2) * Ball::pi(128))).middle());
  for (const cln::cl_I& k : {nearest, nearest + 1, nearest - 1}) {
    const Fraction moved = a - Fraction(cln::cl_RA(k)) * pi();
    const auto is_positive = [&](const Fraction& distance) {
      return ring_.signs_of(ring_.normal(distance)).within(Signs::nonnegative());
    };
    if (is_within(range - point({0, k}), monotone_piece("sin").domain) ||
        (is_positive(pi() / 2 - moved) && is_positive(pi() / 2 + moved)))
      return ring_.normal(is_sine && cln::oddp(k) ? -moved : moved);
  }
  return std::nullopt;
}

std::optional<Fraction> Translator::known_angle(bool is_sine, const Fraction& u) {
  for (const auto& [argument, values] : circular_) {
    const Fraction c = ring_.normal(values.first), s = ring_.normal(values.second);
    for (const bool is_turned : {false, true}) {  // cos a = sin(π/2 - a)
      const Fraction &sine = is_turned ? c : s, &cosine = is_turned ? s : c;
      if (!is_sine && (cosine.is_zero() || sine.numerator.terms() > 100)) continue;
      const Fraction value = ring_.normal(is_sine ? sine : sine / cosine);
      if (value != u && value != -u) continue;
      const auto angle = moved_by_half_turns(is_turned ? pi() / 2 - argument : argument, is_sine);
      if (angle) return value == u ? *angle : -*angle;
    }
  }
  return std::nullopt;
}

/// Returns asin u or atan u as a generator; both are odd.
Fraction Translator::angle(bool is_sine, const Fraction& value) {
  const Fraction u = ring_.normal(value);
  if (u.is_zero()) return 0;
  if (u.numerator.leads_with_minus()) return -angle(is_sine, -u);
  return ring_.function(is_sine ? "asin" : "atan", u);
}

}  // namespace rederive::identity
