// Signs and ranges of polynomials in the generators: what is known of them, and what follows.
#include <algorithm>
#include <derivations/identity/exponential_ring.hpp>

namespace rederive {

namespace {

Signs sign_of_number(const cln::cl_RA& n) {
  return cln::zerop(n) ? Signs::zero() : cln::plusp(n) ? Signs::positive() : Signs::negative();
}

}  // namespace

Signs signs_of(const Interval& values) {
  if (values.is_positive()) return Signs::positive();
  if (values.is_negative()) return Signs::negative();
  return (values.is_nonnegative() ? Signs::nonnegative() : Signs::any()) &
         (values.is_nonpositive() ? Signs::nonpositive() : Signs::any());
}

Fact Ring::essential(const Fraction& value, Signs signs) const {
  const Fraction f = normal(value);
  if (f.is_zero()) return {0, signs};
  const auto& [sign, list] = factors(signs == Signs::zero() ? f.numerator : f.numerator * f.denominator);
  Signs outside = sign_of_number(sign);
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
  const auto note = [&](const Polynomial& p, Signs of_p) {
    Signs& known = known_signs_.try_emplace(p, Signs::any()).first->second;
    known = known & of_p;
  };
  note(fact.value, fact.signs);
  if (signs.is_definite())  // no factor of what is not 0 is 0
    for (const auto& [factor, exponent] : factors(fact.value).second)
      note(factor, signs_of(factor) & Signs::nonzero());
  found_.clear();
  narrow(fact.value, fact.signs);
}

/// c·x + d > 0 bounds x by the values of -d/c, for a number c and a d without x.
void Ring::narrow(const Polynomial& p, Signs signs) {
  for (const int k : p.used()) {
    if (p.degree(k) != 1) continue;
    const auto c = p.coefficients(k);
    if (!c[1].is_constant()) continue;
    const Interval end = range_of(Fraction(-c[0], c[1]));
    const Signs of_x = cln::minusp(c[1].constant()) ? -signs : signs;  // of x + d/c
    Interval bound;
    const bool closed = Signs::zero().within(of_x);
    if (of_x.within(Signs::nonnegative()) && end.low.infinite == 0)
      bound.low = end.low, bound.low.closed = closed && end.low.closed;
    if (of_x.within(Signs::nonpositive()) && end.high.infinite == 0)
      bound.high = end.high, bound.high.closed = closed && end.high.closed;
    narrow(k, bound);
  }
  propagate();
}

/// Whether that says something new.
bool Ring::narrow(int generator, const Interval& range) {
  Interval& known = generators_[generator].range;
  const Interval both = overlap(known, range);
  const auto is_same = [](const End& a, const End& b) { return compare(a, b) == 0 && a.closed == b.closed; };
  if (is_same(both.low, known.low) && is_same(both.high, known.high)) return false;
  known = both;
  return true;
}

/// The range of x from that of f(c·x + d), where f can be inverted.
bool Ring::narrow_backwards(const Generator& g) {
  using Kind = Generator::Kind;
  const auto used = g.of.numerator.used();
  if (used.size() != 1 || g.of.numerator.degree(used[0]) != 1 || !g.of.denominator.is_constant())
    return false;
  const MonotonePiece& f = monotone_piece(g.function);
  const bool is_root = g.kind == Kind::root;
  if (!is_root && f.inverse == nullptr) return false;
  const Interval inside = range_of(g.of);
  const auto lies_in = [&](const Interval& piece) {
    return compare(inside.low, piece.low) >= 0 && compare(inside.high, piece.high) <= 0;
  };
  Interval argument = is_root ? power(g.range, g.degree) : call(f.inverse, g.range);
  if (f.turned == 0) {  // an end that f always has says no more than that f has a value
    if (compare(g.range.low, f.range.low) == 0) argument.low = Interval{}.low;
    if (compare(g.range.high, f.range.high) == 0) argument.high = Interval{}.high;
  } else if (!lies_in(f.domain)) {
    if (g.kind != Kind::cosine || !lies_in(monotone_piece("sin").domain)) return false;
    argument = hull(argument, -argument);  // even
  }
  const auto c = g.of.numerator.coefficients(used[0]);
  if (!c[0].is_constant() || !c[1].is_constant()) return false;
  const cln::cl_RA below = g.of.denominator.constant(), slope = below / cln::cl_RA(c[1].constant());
  return narrow(used[0], (argument - point({c[0].constant() / below})) * point({slope}));
}

/// What a function makes of a narrower range, and the other way round.
void Ring::propagate() {
  bool has_changed = true;
  for (int round = 0; round < 3 && has_changed; ++round) {
    has_changed = false;
    for (std::size_t k = 0; k < generators_.size(); ++k) {
      const Generator g = generators_[k];
      if (g.function.empty()) continue;
      if (g.kind != Generator::Kind::root || g.degree == 2)
        has_changed = narrow(static_cast<int>(k), call(g.function, range_of(g.of))) || has_changed;
      has_changed = narrow_backwards(generators_[k]) || has_changed;
    }
  }
}

Interval Ring::range_of(const Polynomial& p) const {
  if (p.is_zero()) return point({});
  Interval sum = point({});
  for (std::size_t t = 0; t < p.terms(); ++t) {
    Interval product = point({p.coefficient(t)});
    for (const auto& [k, exponent] : p.powers(t)) product = product * power(generators_[k].range, exponent);
    sum = sum + product;
  }
  if (p.is_constant() || known_signs_.empty()) return sum;
  const cln::cl_I number = p.leads_with_minus() ? -p.content() : p.content();
  const Polynomial q = *quotient(p, Polynomial(number));  // content 1, leads with plus
  if (const auto known = known_signs_.find(q); known != known_signs_.end()) {
    const Signs signs = cln::minusp(number) ? -known->second : known->second;
    if (signs == Signs::positive()) sum = overlap(sum, positive_numbers());
    if (signs == Signs::negative()) sum = overlap(sum, -positive_numbers());
  }
  return sum;
}

Interval Ring::range_of(const Fraction& f) const {
  const Interval above = range_of(f.numerator);
  return f.denominator.is_one() ? above : above * reciprocal(range_of(f.denominator));
}

Signs Ring::signs_of(const Polynomial& p) const {
  if (const auto found = found_.find(p); found != found_.end()) return found->second;
  return found_.emplace(p, signs_of(p, 2)).first->second;
}

Signs Ring::signs_of(const Polynomial& p, int depth) const {
  if (p.is_constant()) return sign_of_number(p.constant());
  Signs result = rederive::signs_of(range_of(p));
  const cln::cl_I number = p.leads_with_minus() ? -p.content() : p.content();
  const Polynomial q = *quotient(p, Polynomial(number));  // content 1, leads with plus
  if (const auto known = known_signs_.find(q); known != known_signs_.end())
    result = result & (cln::minusp(number) ? -known->second : known->second);
  if (depth == 0 || result == Signs::positive() || result == Signs::negative() || result.is_none())
    return result;
  const auto& [sign, list] = factors(q);
  if (list.size() == 1 && list[0].second == 1)
    return result & signs_of_coefficients(p, depth - 1) & signs_of_quadratic(p, depth - 1);
  Signs product = sign_of_number(number);
  for (const auto& [factor, exponent] : list)
    product = product * power(signs_of(factor, depth - 1), exponent);
  return result & product;
}

/// As a polynomial in the symbols, the other generators in its coefficients: g·(4s - 3s³) + a·(c - c³) term
/// by term.
Signs Ring::signs_of_coefficients(const Polynomial& p, int depth) const {
  if (p.terms() > 40) return Signs::any();
  std::map<Polynomial, Polynomial> coefficients;
  for (std::size_t t = 0; t < p.terms(); ++t) {
    Polynomial of_symbols = 1, other = Polynomial(p.coefficient(t));
    for (const auto& [k, exponent] : p.powers(t)) {
      Polynomial& part = generators_[k].kind == Generator::Kind::symbol ? of_symbols : other;
      part = part * power(Polynomial::variable(k), exponent);
    }
    Polynomial& sum = coefficients[of_symbols];
    sum = sum + other;
  }
  if (coefficients.size() == p.terms() || coefficients.size() == 1) return Signs::any();
  Signs all = Signs::zero();
  for (const auto& [monomial, coefficient] : coefficients)
    all = sum_of(all, signs_of(monomial, 0) * signs_of(coefficient, depth));
  return all;
}

/// 4a·(a x² + b x + c) = (2a x + b)² - (b² - 4ac).
Signs Ring::signs_of_quadratic(const Polynomial& p, int depth) const {
  for (const int k : p.used()) {
    auto c = p.coefficients(k);
    if (c.size() == 5 && c[1].is_zero() && c[3].is_zero()) c = {c[0], c[2], c[4]};  // in the square
    if (c.size() != 3) continue;
    const Signs leading = signs_of(c[2], depth);
    if (leading != Signs::positive() && leading != Signs::negative()) continue;
    const Fraction discriminant = reduced(c[1] * c[1] - 4 * c[0] * c[2]);
    const Signs of_discriminant =
        signs_of(discriminant.numerator, depth) * signs_of(discriminant.denominator, depth);
    if (of_discriminant == Signs::negative()) return leading;
    if (of_discriminant.within(Signs::nonpositive())) return leading | Signs::zero();
  }
  return Signs::any();
}

}  // namespace rederive
