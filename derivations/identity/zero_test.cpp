// Decides whether a fraction of the ring is 0.
#include <algorithm>
#include <derivations/identity/translator.hpp>

namespace rederive::identity {
using namespace numbers;
namespace {
/// Returns whether d = -e·g, from d² = e²·g² and the signs.
bool vanishes_by_conjugates(const Ring& ring, const Polynomial& p, int depth) {
  if (p.is_zero()) return true;
  if (depth == 0 || p.terms() > 60) return false;
  for (const int k : p.used()) {
    if (ring.generators()[k].degree != 2) continue;
    const auto c = p.coefficients(k);
    const Polynomial variable = Polynomial::variable(k);
    if (c.size() != 2) continue;
    const Signs one = ring.signs_of(c[0]), other = -ring.signs_of(c[1] * variable);
    const auto are_both = [&](Signs signs) { return one.within(signs) && other.within(signs); };
    if (!are_both(Signs::nonnegative()) && !are_both(Signs::nonpositive())) continue;
    if (vanishes_by_conjugates(ring, ring.norm(p, k).numerator, depth - 1)) return true;
  }
  return false;
}

/// Returns whether d is a sum of a number and multiples of symbols, angles and π, within ±turns·π.
bool is_angle(const Ring& ring, const Fraction& d, int turns) {
  const Interval range = ring.range_of(d);
  if (!d.denominator.is_constant() || compare(range.low, End{{0, -turns}}) <= 0 ||
      compare(range.high, End{{0, turns}}) >= 0)
    return false;
  for (std::size_t t = 0; t < d.numerator.terms(); ++t) {
    const auto powers = d.numerator.powers(t);
    if (powers.empty()) continue;
    if (powers.size() != 1) return false;
    const Generator& g = ring.generators()[powers[0].first];
    if (!g.function.empty() && !g.is_angle()) return false;
  }
  return true;
}

/// Returns u/v for u - v with two positive terms.
std::optional<Fraction> ratio_of_terms(const Ring& ring, const Polynomial& p) {
  if (p.terms() != 2 || cln::signum(p.coefficient(0)) == cln::signum(p.coefficient(1))) return std::nullopt;
  for (const int k : p.used())
    if (ring.signs_of(Polynomial::variable(k)) != Signs::positive()) return std::nullopt;
  const auto term = [&](int k) { return Polynomial(cln::abs(p.coefficient(k))) * p.monomial(k); };
  return Fraction(term(0), term(1));
}

}  // namespace

bool vanishes(const Fraction& f, const Ring& ring) {
  const Polynomial p = ring.normal(f).numerator;
  if (p.is_zero() || p.terms() > 60) return p.is_zero();
  const auto factor_vanishes = [&](const auto& factor) {
    return vanishes_by_conjugates(ring, factor.first, 3);
  };
  return std::ranges::any_of(factors(p).second, factor_vanishes);
}

std::vector<Fraction> zeros_like(const Fraction& f, Ring& ring, Translator& translator) {
  const Fraction d = ring.normal(f);
  std::vector<Fraction> result{d};
  const auto used = d.numerator.used();
  const auto is_logarithm = [&](int k) { return ring.generators()[k].function == "log"; };
  try {
    if (is_angle(ring, d, 1)) result.push_back(translator.circular(d).second);
    if (is_angle(ring, d, 2)) result.push_back(ring.normal(1 - translator.circular(d).first));
    if (std::ranges::any_of(used, is_logarithm)) result.push_back(translator.exponential(d) - 1);
    if (const auto u = ratio_of_terms(ring, d.numerator)) result.push_back(translator.logarithm(*u));
  } catch (const OtherBasis&) {
    throw;
  } catch (const Undecidable&) {
  }
  return result;
}

bool vanishes(const Fraction& f, Ring& ring, Translator& translator, int depth) {
  if (vanishes(f, ring)) return true;
  const Polynomial p = ring.normal(f).numerator;
  const auto is_inverse = [&](const Generator& g) { return g.is_angle() || g.function == "log"; };
  if (p.terms() > 60 || std::ranges::none_of(ring.generators(), is_inverse)) return false;
  const auto is_zero = [&](const Fraction& z) { return vanishes(z, ring); };
  const auto part_vanishes = [&](const Polynomial& c) { return vanishes(c, ring, translator, depth - 1); };
  for (const auto& [factor, exponent] : factors(p).second) {
    cln::cl_I scale = 0;  // of angles, beside π
    for (std::size_t t = 0; t < factor.terms(); ++t)
      if (!(factor.monomial(t) == translator.pi().numerator)) scale = cln::gcd(scale, factor.coefficient(t));
    if (factor.is_constant() || cln::zerop(scale)) continue;
    if (std::ranges::any_of(zeros_like(Fraction(factor, Polynomial(scale)), ring, translator), is_zero))
      return true;
    for (const int k : factor.used())
      if (depth > 0 && ring.generators()[k].function.empty() &&
          std::ranges::all_of(factor.coefficients(k), part_vanishes))
        return true;
  }
  return false;
}

}  // namespace rederive::identity
