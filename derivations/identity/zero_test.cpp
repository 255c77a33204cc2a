#include <derivations/identity/translator.hpp>

namespace rederive {

using Kind = Generator::Kind;

namespace {

bool is_opposite(Signs a, Signs b) {
  return (a.within(Signs::nonnegative()) && b.within(Signs::nonpositive())) ||
         (a.within(Signs::nonpositive()) && b.within(Signs::nonnegative()));
}

/// d = -e·g, from d² = e²·g² and the signs.
bool vanishes_by_conjugates(const Ring& ring, const Polynomial& p, int depth) {
  if (p.is_zero()) return true;
  if (depth == 0 || p.terms() > 60) return false;
  for (const int k : p.used()) {
    if (ring.generators()[k].degree != 2) continue;
    const auto c = p.coefficients(k);
    const Polynomial variable = Polynomial::variable(k);
    if (c.size() != 2 || !is_opposite(ring.signs_of(c[0]), ring.signs_of(c[1] * variable))) continue;
    if (vanishes_by_conjugates(ring, ring.norm(p, k).numerator, depth - 1)) return true;
  }
  return false;
}

bool has(const Ring& ring, const Fraction& f, Kind kind) {
  for (const int k : f.numerator.used())
    if (ring.generators()[k].kind == kind) return true;
  return false;
}

bool lies_within_a_turn(const Interval& range) {
  return compare(range.low, End{{0, -2}}) > 0 && compare(range.high, End{{0, 2}}) < 0;
}

}  // namespace

bool vanishes(const Fraction& f, Ring& ring, Translator& translator) {
  const Fraction d = ring.normal(f);
  if (vanishes_by_conjugates(ring, d.numerator, 3)) return true;
  const auto is_zero = [&](const Fraction& value) {
    return vanishes_by_conjugates(ring, ring.normal(value).numerator, 3);
  };
  try {
    if (has(ring, d, Kind::angle) && lies_within_a_turn(ring.range_of(d))) {
      const auto [cosine, sine] = translator.circular_of(d);
      return is_zero(cosine - 1) && is_zero(sine);
    }
    if (has(ring, d, Kind::logarithm)) return is_zero(translator.exponential_of(d) - 1);
  } catch (const Undecidable&) {
  }
  return false;
}

}  // namespace rederive
