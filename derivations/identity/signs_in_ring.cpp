// Signs and ranges of polynomials in the generators: known ones, and those that follow.
#include <derivations/identity/exponential_ring.hpp>
#include <derivations/language/functions.hpp>

namespace rederive::identity {
using namespace language;
using namespace numbers;

Signs signs_of(const Interval& values) {
  if (values.is_positive()) return Signs::positive();
  if (values.is_negative()) return Signs::negative();
  return (values.is_nonnegative() ? Signs::nonnegative() : Signs::any()) &
         (values.is_nonpositive() ? Signs::nonpositive() : Signs::any());
}

Interval values_of(Signs signs) {
  Interval result;
  const End end{{}, 0, Signs::zero().within(signs)};
  if (signs.within(Signs::nonnegative())) result.low = end;
  if (signs.within(Signs::nonpositive())) result.high = end;
  return result;
}

Fact Ring::essential(const Fraction& value, Signs signs) const {
  const Fraction f = normal(value);
  if (f.is_zero()) return {0, signs};
  const auto& [sign, list] = factors(signs == Signs::zero() ? f.numerator : f.numerator * f.denominator);
  Signs outside = rederive::identity::signs_of(point({sign}));
  Polynomial rest = 1;
  for (const auto& [factor, exponent] : list) {
    const Signs known = power(signs_of(factor), exponent);
    const bool is_odd = exponent % 2 != 0;
    if (known == Signs::positive() || known == Signs::negative())
      outside = outside * known;
    else if (signs != Signs::zero() || !known.is_definite())
      rest = rest * power(factor, is_odd || signs == Signs::zero() ? 1 : 2);
  }
  return {rest, outside == Signs::negative() ? -signs : signs};
}

void Ring::learn(const Fraction& value, Signs signs) {
  if (signs_of(normal(value)).within(signs)) return;
  const Fact fact = essential(value, signs);
  if (fact.value.is_constant()) return;
  Signs& known = known_signs_.try_emplace(fact.value, Signs::any()).first->second;
  known = known & fact.signs;
  found_.clear();
  narrow(fact.value, values_of(fact.signs)), propagate();
}

/// Narrows x by (interval - d)/c if c·x + d is in an interval, for a number c and a d without x.
bool Ring::narrow(const Polynomial& p, const Interval& values) {
  bool has_changed = false;
  for (const int k : p.used()) {
    const auto c = p.coefficients(k);
    if (c.size() != 2 || !c[1].is_constant()) continue;
    const Interval x = (values - range_of(c[0])) * point({1 / cln::cl_RA(c[1].constant())});
    has_changed = narrow(k, x) || has_changed;
  }
  return has_changed;
}

/// Narrows the range of a generator. Returns whether the range changed.
bool Ring::narrow(int generator, const Interval& range) {
  Interval& known = generators_[generator].range;
  if (is_within(known, range)) return false;
  known = overlap(known, range);
  return true;
}

/// Narrows u from the values of f(u), if f can be inverted.
bool Ring::narrow_backwards(const Generator& g) {
  const MonotonePiece& f = monotone_piece(g.function);
  const bool is_root = g.function == "sqrt";
  if ((!is_root && f.inverse.empty()) || !g.of.denominator.is_constant()) return false;
  const Interval inside = range_of(g.of);
  Interval argument = is_root ? power(g.range, g.degree) : call(f.inverse, g.range);
  if (f.half_turn == 0) {  // an end that f always has says no more than that f has a value
    if (compare(g.range.low, f.range.low) == 0) argument.low = Interval{}.low;
    if (compare(g.range.high, f.range.high) == 0) argument.high = Interval{}.high;
  } else if (!is_within(inside, f.domain)) {
    const bool is_even = function_named(g.function).parity == Function::Parity::even;
    if (!is_even || !is_within(inside, monotone_piece("sin").domain)) return false;
    argument = hull(argument, -argument);
  }
  return narrow(g.of.numerator, argument * point({g.of.denominator.constant()}));
}

/// Narrows functions by the ranges of their arguments, and arguments by the ranges of functions.
void Ring::propagate() {
  bool has_changed = true;
  for (int round = 0; round < 3 && has_changed; ++round) {
    has_changed = false;
    for (std::size_t k = 0; k < generators_.size(); ++k) {
      const Generator g = generators_[k];
      if (find_function(g.function) == nullptr) continue;
      const Interval of = range_of(g.of), values = g.function == "sqrt" ? power(of, cln::cl_RA(1) / g.degree)
                                                                        : call(g.function, of);
      has_changed = narrow(static_cast<int>(k), values) || has_changed;
      has_changed = narrow_backwards(generators_[k]) || has_changed;
    }
  }
}

/// Returns the signs that were learned of p or -p.
Signs Ring::known_signs(const Polynomial& p) const {
  const auto known = p.is_constant() ? known_signs_.end() : known_signs_.find(p.primitive());
  return known == known_signs_.end() ? Signs::any() : p.leads_with_minus() ? -known->second : known->second;
}

Interval Ring::range_of(const Polynomial& p) const {
  Interval sum = point({});
  for (std::size_t t = 0; t < p.terms(); ++t) {
    Interval product = point({p.coefficient(t)});
    for (const auto& [k, exponent] : p.powers(t)) product = product * power(generators_[k].range, exponent);
    sum = sum + product;
    if (sum.low.infinite != 0 && sum.high.infinite != 0) break;
  }
  return overlap(sum, values_of(known_signs(p)));
}

Interval Ring::range_of(const Fraction& f) const {
  const Interval above = range_of(f.numerator);
  return f.denominator.is_one() ? above : above * reciprocal(range_of(f.denominator));
}

Signs Ring::signs_of(const Polynomial& p, int depth) const {
  if (p.is_constant()) return rederive::identity::signs_of(point({p.constant()}));
  const auto [found, is_new] = found_.try_emplace({p, depth}, Signs::any());
  return is_new ? found->second = signs_anew(p, depth) : found->second;
}

Signs Ring::signs_anew(const Polynomial& p, int depth) const {
  const Signs result = rederive::identity::signs_of(range_of(p)) & known_signs(p);
  if (depth == 0 || result == Signs::positive() || result == Signs::negative() || result.is_none())
    return result;
  const auto& [sign, list] = factors(p.primitive());
  if (list.size() == 1 && list[0].second == 1) return result & signs_of_irreducible(p, depth - 1);
  Signs product = p.leads_with_minus() ? Signs::negative() : Signs::positive();
  for (const auto& [factor, exponent] : list)
    product = product * power(signs_of(factor, depth - 1), exponent);
  return result & product;
}

/// Returns the signs of p as a polynomial in one generator x after another: by the signs of its terms; for a
/// square root x, d + e·x has the sign of d or of e·x, whichever square is larger; for a quadratic in x or
/// x², by 4a·(a x² + b x + c) = (2a x + b)² - (b² - 4ac).
Signs Ring::signs_of_irreducible(const Polynomial& p, int depth) const {
  Signs result = Signs::any();
  for (const int k : p.used()) {
    auto c = p.coefficients(k);
    Signs sum = signs_of(c[0], depth);
    for (int n = 1; n < static_cast<int>(c.size()) && sum != Signs::any(); ++n)
      sum = sum_of(sum, power(rederive::identity::signs_of(generators_[k].range), n) * signs_of(c[n], depth));
    result = result & sum;
    if (generators_[k].function == "sqrt" && generators_[k].degree == 2 && c.size() == 2) {
      const Fraction n = norm(p, k);
      const Signs order = signs_of(n.numerator, depth) * signs_of(n.denominator, depth),
                  edge = order.is_definite() ? Signs::nonzero() : Signs::any();
      if (order.within(Signs::nonnegative()))
        result = result & edge & (signs_of(c[0], depth) | Signs::zero());
      if (order.within(Signs::nonpositive()))
        result = result & edge & (signs_of(c[1], depth) | Signs::zero());
    }
    if (c.size() == 5 && c[1].is_zero() && c[3].is_zero()) c = {c[0], c[2], c[4]};
    if (c.size() != 3) continue;
    const Signs leading = signs_of(c[2], depth);
    if (leading != Signs::positive() && leading != Signs::negative()) continue;
    const Fraction rest = reduced(c[1] * c[1] - 4 * c[0] * c[2]);
    const Signs discriminant = signs_of(rest.numerator, depth) * signs_of(rest.denominator, depth);
    if (discriminant.within(Signs::nonpositive()))
      result = result & (discriminant.is_definite() ? leading : leading | Signs::zero());
  }
  return result;
}

}  // namespace rederive::identity
