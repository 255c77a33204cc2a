// Roots and sizes: what is known to have no negative values comes out of a root or its bars, factor by
// factor.
#include <algorithm>
#include <derivations/identity/translator.hpp>
#include <numeric>

namespace rederive {

using Kind = Generator::Kind;

namespace {

Interval range_of_root(const Interval& base, int order) {
  const Interval u = overlap(base, nonnegative_numbers());
  if (order == 2) return rederive::call("sqrt", u);
  if (!u.is_positive()) return nonnegative_numbers();
  return rederive::call("exp", rederive::call("log", u) * point({cln::cl_RA(1) / order}));
}

}  // namespace

/// The positive root of a positive number, prime by prime; a large cofactor stays whole.
Fraction Translator::root_of_number(const cln::cl_I& number, int order) {
  Fraction result = 1;
  cln::cl_I rest = number;
  const auto take = [&](const cln::cl_I& prime, int count) {
    for (int k = 0; k < count / order; ++k) result = result * Fraction(Polynomial(prime));
    if (count % order != 0)
      for (int k = 0; k < count % order; ++k)
        result = ring_.normal(result * root_generator(Polynomial(prime), order));
  };
  for (cln::cl_I prime = 2; prime * prime <= rest && prime < 2000; prime = prime + 1) {
    int count = 0;
    while (cln::zerop(cln::mod(rest, prime))) rest = cln::exquo(rest, prime), ++count;
    if (count > 0) take(prime, count);
  }
  if (rest != 1) take(rest, 1);
  return ring_.normal(result);
}

/// y with y^order = base, y >= 0: a power of the generator whose order all roots of this base share.
Fraction Translator::root_generator(const Polynomial& base, int order) {
  const int part = base == 2 ? 4 : base == 3 ? 6 : 0;  // √2 = 2 cos π/4, √3 = 2 cos π/6
  if (order == 2 && part != 0 && parts_of_pi_ % part == 0)
    return 2 * cosine_of_part(parts_of_pi_ / part, parts_of_pi_);
  const std::string key = base.key();
  int& common = root_orders_.try_emplace(key, order).first->second;
  if (common % order != 0) {
    common = std::lcm(common, order);
    if (common > 60) throw Undecidable("roots of a high order");
    throw AnotherRound();
  }
  const Fraction y = ring_.generator("root " + std::to_string(common) + " " + key, [&] {
    Generator g;
    g.kind = Kind::root, g.of = base, g.order = g.degree = common, g.value = base;
    g.meaning = GiNaC::pow(ring_.meaning_of(base), GiNaC::numeric(1, common));
    g.range = range_of_root(ring_.range_of(Fraction(base)), common);
    return g;
  });
  return power(y, common / order);
}

Fraction Translator::root(const Fraction& value, int order) {
  const Fraction u = ring_.normal(value);
  if (u.is_zero()) return 0;
  // (n/d)^{1/k} = (n d^{k-1})^{1/k} / |d|
  const Polynomial product = u.numerator * power(u.denominator, order - 1);
  const auto& [number, list] = factors(product);
  Fraction outside = 1 / absolute(u.denominator);
  Polynomial inside = cln::minusp(number) ? -1 : 1;
  const bool is_known = std::all_of(list.begin(), list.end(), [&](const auto& f) {
    const Signs signs = ring_.signs_of(f.first);
    return f.second % 2 == 0 || signs.within(Signs::nonnegative()) || signs.within(Signs::nonpositive());
  });
  std::vector<std::pair<Polynomial, int>> unknown;
  for (const auto& [factor, exponent] : list) {
    const Signs signs = ring_.signs_of(factor);
    const bool negative = signs.within(Signs::nonpositive()),
               has_sign = negative || signs.within(Signs::nonnegative());
    if (!has_sign || (!is_known && !signs.is_definite())) {  // where it is 0 the rest may have no root
      unknown.emplace_back(factor, exponent);
      continue;
    }
    const Polynomial size = negative ? -factor : factor;
    if (negative && exponent % 2 != 0) inside = -inside;
    outside = outside * Fraction(power(size, exponent / order));
    for (int k = 0; k < exponent % order; ++k) outside = ring_.normal(outside * root_generator(size, order));
  }
  Polynomial odd = 1;
  for (const auto& [factor, exponent] : unknown)
    if (exponent % 2 != 0) odd = odd * factor;
  const bool stays =
      !odd.is_constant() || inside.leads_with_minus();  // then a root of the rest may be missing
  for (const auto& [factor, exponent] : unknown) {
    // an even power is a size; together with what may be negative it comes out only where it is not 0
    const bool comes_out = !stays || ring_.signs_of(factor).is_definite();
    const int even = exponent - exponent % 2;
    const Polynomial size = absolute(factor).numerator;
    if (!comes_out) inside = inside * power(factor, even);
    for (int k = 0; comes_out && k < even / order; ++k) outside = ring_.normal(outside * size);
    for (int k = 0; comes_out && k < even % order; ++k)
      outside = ring_.normal(outside * root_generator(size, order));
  }
  inside = inside * odd;
  outside = ring_.normal(outside * root_of_number(cln::abs(number), order));
  if (inside.is_one()) return outside;
  if (inside.is_constant()) throw NoValue("the root of a negative number");
  return ring_.normal(outside * root_generator(inside, order));
}

/// (t^n)^{1/k} = |t|^{n/k} for an even n, before anything is multiplied out.
Fraction Translator::root_of(const Tree& tree, int order) {
  if (tree->kind == Node::Kind::power) {
    const Fraction exponent = translate(tree->children[1]);
    const cln::cl_RA n = exponent.is_constant() ? exponent.constant() : cln::cl_RA(0);
    if (cln::plusp(n) && n <= 64 && cln::denominator(n) == 1 && cln::evenp(cln::numerator(n))) {
      const int even = cln::cl_I_to_int(cln::numerator(n)), common = std::gcd(even, order);
      const Fraction size = absolute(translate(tree->children[0]));
      Fraction result = 1;
      const Fraction factor = common == order ? size : root(size, order / common);
      for (int k = 0; k < even / common; ++k) result = ring_.normal(result * factor);
      return result;
    }
  }
  return root(translate(tree), order);
}

/// |u|, factor by factor; without the bars where the sign is known.
Fraction Translator::absolute(const Fraction& value) {
  const Fraction u = ring_.normal(value);
  const auto size = [&](const Polynomial& p) -> Fraction {
    if (p.is_constant()) return Polynomial(cln::abs(p.constant()));
    const auto& [number, list] = factors(p);
    Fraction result = Polynomial(cln::abs(number));
    for (const auto& [factor, exponent] : list) {
      const Signs signs = ring_.signs_of(factor);
      if (exponent % 2 == 0 || signs.within(Signs::nonnegative())) {
        result = result * Fraction(power(factor, exponent));
      } else if (signs.within(Signs::nonpositive())) {
        result = result * Fraction(power(-factor, exponent));
      } else {
        const Fraction square = factor * factor;
        const Fraction a = ring_.generator("abs " + factor.key(), [&] {
          Generator g;
          g.kind = Kind::absolute, g.of = factor, g.meaning = GiNaC::abs(ring_.meaning_of(factor));
          g.degree = 2, g.value = square, g.range = rederive::call("fabs", ring_.range_of(Fraction(factor)));
          return g;
        });
        result = result * a * Fraction(power(factor, exponent - 1));
      }
    }
    return result;
  };
  return ring_.normal(size(u.numerator) / size(u.denominator));
}

}  // namespace rederive
