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

/// y with y^order = base, y >= 0: a power of the generator whose order all roots of this base share.
Fraction Translator::root_generator(const Polynomial& base, int order) {
  const int part = base == 2 ? 4 : base == 3 ? 6 : 0;  // √2 = 2 cos π/4, √3 = 2 cos π/6
  if (order == 2 && part != 0 && cln::zerop(cln::mod(denominators_.at("turn"), part)))
    return 2 * circular(pi() / part).first;
  const std::string key = base.key();
  int& common = root_orders_.try_emplace(key, order).first->second;
  if (common % order != 0) {
    common = std::lcm(common, order);
    if (common > 60) throw Undecidable("roots of a high order");
    throw OtherBasis();
  }
  const Fraction y = ring_.generator("root " + std::to_string(common) + " " + key, [&] {
    const GiNaC::ex meaning = pow(ring_.meaning_of(base), GiNaC::numeric(1, common));
    const Interval range = range_of_root(ring_.range_of(Fraction(base)), common);
    return Generator{Kind::root, meaning, range, base, common, base, "sqrt"};
  });
  return power(y, common / order);
}

Fraction Translator::root(const Fraction& value, int order) {
  const Fraction u = ring_.normal(value);
  if (u.is_zero()) return 0;
  // (n/d)^{1/k} = (n d^{k-1})^{1/k} / |d|
  const auto& [sign, list] = factors(u.numerator * power(u.denominator, order - 1));
  Signs of_odd = sign < 0 ? Signs::negative() : Signs::positive();
  for (const auto& [factor, exponent] : list)
    if (exponent % 2 != 0) of_odd = of_odd * ring_.signs_of(factor);
  Fraction outside = 1 / absolute(u.denominator);
  Polynomial inside = sign;
  for (const auto& [factor, exponent] : list) {
    const Signs signs = ring_.signs_of(factor);
    const bool is_negative = signs.within(Signs::nonpositive()),
               has_sign = is_negative || signs.within(Signs::nonnegative());
    // beside what may be negative, what may be 0 stays: where it is 0 the rest may have no root
    const bool comes_out = of_odd.within(Signs::nonnegative()) || signs.is_definite();
    const int taken = !comes_out ? 0 : has_sign ? exponent : exponent - exponent % 2;
    if (is_negative && taken % 2 != 0) inside = -inside;
    inside = inside * power(factor, exponent - taken);
    if (taken > 0) outside = outside * Fraction(power(size_of(factor), taken / order));
    if (taken % order != 0) outside = outside * power(root_generator(size_of(factor), order), taken % order);
  }
  if (inside.is_one()) return ring_.normal(outside);
  if (inside.is_constant()) throw NoValue("the root of a negative number");
  return ring_.normal(outside * root_generator(inside, order));
}

/// √(t^{2n}) = |t|^n, before anything is multiplied out.
Fraction Translator::square_root(const Tree& tree) {
  const Fraction value = translate(tree);
  const bool is_power = tree->kind == Node::Kind::power && tree->children[1]->kind == Node::Kind::number;
  const cln::cl_RA half = is_power ? exact(tree->children[1]->text) / 2 : cln::cl_RA(1) / 2;
  if (cln::denominator(half) != 1) return root(value, 2);
  return ring_.normal(power(absolute(translate(tree->children[0])), cln::cl_I_to_int(cln::numerator(half))));
}

/// The size of an irreducible polynomial: without bars where its sign is known.
Polynomial Translator::size_of(const Polynomial& factor) {
  const Signs signs = ring_.signs_of(factor);
  if (signs.within(Signs::nonnegative())) return factor;
  if (signs.within(Signs::nonpositive())) return -factor;
  return ring_.function(Kind::absolute, "fabs", factor, 2, factor * factor).numerator;
}

/// |u|, factor by factor.
Fraction Translator::absolute(const Fraction& value) {
  const Fraction u = ring_.normal(value);
  Fraction result = 1;
  for (const int side : {1, -1}) {
    const auto& [sign, list] = factors(side > 0 ? u.numerator : u.denominator);
    Polynomial size = std::abs(sign);
    for (const auto& [factor, exponent] : list)
      size = size * power(exponent % 2 == 0 ? factor : size_of(factor), exponent);
    result = side > 0 ? Fraction(size) : result / size;
  }
  return ring_.normal(result);
}

}  // namespace rederive
