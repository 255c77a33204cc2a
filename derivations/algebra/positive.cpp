#include <algorithm>
#include <cmath>
#include <derivations/algebra/evaluate.hpp>
#include <derivations/algebra/positive.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <vector>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

constexpr std::size_t most_terms = 40;
constexpr int highest_degree = 12;

/// Of 1, t, t² …; the last one is not 0.
using Coefficients = std::vector<numeric>;

std::optional<Coefficients> coefficients(const ex& polynomial, const GiNaC::symbol& x) {
  const ex p = polynomial.expand();
  if (!p.is_polynomial(x) || p.degree(x) > highest_degree) return std::nullopt;
  Coefficients result;
  for (int k = 0; k <= p.degree(x); ++k) {
    const ex c = p.coeff(x, k);
    if (!is_a<numeric>(c) || !ex_to<numeric>(c).is_rational()) return std::nullopt;
    result.push_back(ex_to<numeric>(c));
  }
  return result;
}

ex in(const Coefficients& c, const ex& t) {
  ex sum = 0;
  for (std::size_t k = 0; k < c.size(); ++k) sum += c[k] * GiNaC::pow(t, static_cast<int>(k));
  return sum;
}

Coefficients times(const Coefficients& a, const Coefficients& b) {
  Coefficients result(a.size() + b.size() - 1, 0);
  for (std::size_t j = 0; j < a.size(); ++j)
    for (std::size_t k = 0; k < b.size(); ++k) result[j + k] = result[j + k] + a[j] * b[k];
  return result;
}

/// A quick look at a few t >= 0: most of what is asked for is not positive.
bool may_be_positive(const Coefficients& c) {
  if (c.front().is_negative() || !c.back().is_positive()) return false;
  for (const numeric& t : {numeric(1, 8), numeric(1, 2), numeric(1), numeric(2), numeric(8)}) {
    numeric sum = 0;
    for (auto term = c.rbegin(); term != c.rend(); ++term) sum = sum * t + *term;
    if (!sum.is_positive()) return false;
  }
  return true;
}

/// Multiplies by 1 + t until no coefficient is negative. Pólya: for what is positive where t >= 0 that ends.
bool raise(Coefficients& c) {
  if (!may_be_positive(c)) return false;
  while (std::any_of(c.begin(), c.end(), [](const numeric& n) { return n.is_negative(); })) {
    if (c.size() == most_terms) return false;
    c = times(c, {1, 1});
  }
  return true;
}

/// Where t >= 0.
std::optional<ex> on_ray(const Coefficients& c, const ex& t) {
  Coefficients raised = c;
  if (c.empty() || !raise(raised)) return std::nullopt;
  const int n = static_cast<int>(raised.size() - c.size());
  ex sum = 0;
  for (std::size_t k = 0; k < raised.size(); ++k)
    sum += raised[k] * GiNaC::pow(t, static_cast<int>(k)) / GiNaC::pow(1 + t, n);
  return sum;
}

/// Between a and b: with x = (a + b t)/(1 + t) it is a polynomial in t >= 0 over (1 + t)^n. What all terms
/// have in common, d (1 + t)^n, is taken out.
std::optional<ex> between(const ex& p, const GiNaC::symbol& x, const numeric& a, const numeric& b) {
  const GiNaC::realsymbol t("t");
  const int degree = p.degree(x);
  ex whole = 0;
  for (int k = 0; k <= degree; ++k)
    whole += p.coeff(x, k) * GiNaC::pow(a + b * t, k) * GiNaC::pow(1 + t, degree - k);
  auto c = coefficients(whole, t);
  if (!c) return std::nullopt;
  while (c->size() < static_cast<std::size_t>(degree) + 1) c->push_back(0);
  const bool is_strict = c->front().is_positive() && c->back().is_positive();
  const auto is_enough = [&](const numeric& n) { return is_strict ? n.is_positive() : !n.is_negative(); };
  while (!std::all_of(c->begin(), c->end(), is_enough)) {
    if (c->size() == most_terms || c->front().is_negative() || c->back().is_negative()) return std::nullopt;
    *c = times(*c, {1, 1});
  }
  const int n = static_cast<int>(c->size()) - 1;
  const auto binomial = [n](int k) { return GiNaC::binomial(numeric(n), numeric(k)); };
  numeric least = c->front();
  for (int k = 0; k <= n; ++k) least = std::min(least, (*c)[k] / binomial(k));
  ex sum = least;
  for (int k = 0; k <= n; ++k)
    sum += ((*c)[k] - least * binomial(k)) / GiNaC::pow(b - a, n) * GiNaC::pow(x - a, k) *
           GiNaC::pow(b - x, n - k);
  return sum;
}

std::optional<ex> everywhere(const Coefficients& c, const ex& x) {
  if (c.size() % 2 == 0) return std::nullopt;  // an odd power leads
  Coefficients even, odd;
  for (std::size_t k = 0; k < c.size(); ++k) (k % 2 == 0 ? even : odd).push_back(c[k]);
  const ex square = GiNaC::pow(x, 2);
  const auto e = on_ray(even, square);
  if (!e || std::all_of(odd.begin(), odd.end(), [](const numeric& n) { return n.is_zero(); })) return e;
  Coefficients d = times(even, even);
  const Coefficients other = times({0, 1}, times(odd, odd));
  for (std::size_t k = 0; k < other.size(); ++k) d[k] = d[k] - other[k];
  const auto rest = on_ray(d, square);
  return rest ? std::optional<ex>((GiNaC::pow(in(c, x), 2) + *rest) / (2 * *e)) : std::nullopt;
}

bool is_rational(const ex& e) { return is_a<numeric>(e) && ex_to<numeric>(e).is_rational(); }

/// A rational number at the end of a range, or up to two parts of 1 outside of it.
numeric rational_end(const End& end, int outward, int parts) {
  if (is_rational(end.value)) return ex_to<numeric>(end.value);
  const auto value = evaluate(to_tree(end.value), {}, 10);
  if (!value || cln::abs(*value) > 1'000'000) throw std::domain_error("no end to calculate with");
  return numeric(cln::round1(*value * parts) + outward) / parts;
}

/// By one of the three theorems.
std::optional<ex> form_between(const End& low, const End& high, const Coefficients& c, const GiNaC::symbol& x,
                               int parts) {
  const bool below = low.infinite == 0, above = high.infinite == 0;
  if (below && above)
    return between(in(c, x), x, rational_end(low, -1, parts), rational_end(high, +1, parts));
  if (!below && !above) return everywhere(c, x);
  const GiNaC::realsymbol t("t");
  const ex end = below ? rational_end(low, -1, parts) : rational_end(high, +1, parts);
  const auto moved = coefficients(in(c, below ? end + t : end - t), t);
  return moved ? on_ray(*moved, below ? x - end : end - x) : std::nullopt;
}

/// Where ends are not rational, first with rational ones far outside: next to the ends their powers are too
/// close to 0 to be seen.
std::optional<ex> form_at_once(const Coefficients& c, const GiNaC::symbol& x, const Interval& range) {
  const bool is_exact = is_rational(range.low.value) && is_rational(range.high.value);
  if (const auto form = is_exact ? std::nullopt : everywhere(c, x)) return form;
  for (const int parts : {8, 1000, 1'000'000})
    if (const auto form = form_between(range.low, range.high, c, x, parts); form || is_exact) return form;
  return std::nullopt;
}

double value_at(const Coefficients& c, double x) {
  double sum = 0;
  for (auto term = c.rbegin(); term != c.rend(); ++term) sum = sum * x + term->to_double();
  return sum;
}

/// About where it is smallest, away from the ends: those are no trouble.
double lowest(const Coefficients& c, const Interval& range) {
  constexpr int points = 400;
  const double low = range.low.infinite == 0 ? rational_end(range.low, 0, 1'000'000).to_double() : -HUGE_VAL,
               high =
                   range.high.infinite == 0 ? rational_end(range.high, 0, 1'000'000).to_double() : HUGE_VAL;
  const auto place = [&](double u) {  // 0 < u < 1
    if (std::isfinite(low) && std::isfinite(high)) return low + u * (high - low);
    return std::isfinite(low)    ? low + u / (1 - u)
           : std::isfinite(high) ? high - u / (1 - u)
                                 : (2 * u - 1) / (u * (1 - u));
  };
  const auto height = [&](double u) { return value_at(c, place(u)); };
  double best = 0.5;
  for (int k = 1; k < points; ++k)
    if (height(k / static_cast<double>(points)) < height(best)) best = k / static_cast<double>(points);
  double left = best - 1.0 / points, right = best + 1.0 / points;
  for (int k = 0; k < 60; ++k) {
    const double first = left + (right - left) / 3, second = right - (right - left) / 3;
    (height(first) < height(second) ? right : left) = height(first) < height(second) ? second : first;
  }
  return place((left + right) / 2);
}

std::optional<ex> form_without_squares(const Coefficients& c, const GiNaC::symbol& x, const Interval& range,
                                       int depth);

/// Squares apart: they may be 0 inside of the range, where no other form shows anything.
std::optional<ex> rational_form(const ex& polynomial, const GiNaC::symbol& x, const Interval& range,
                                int depth = 0);

/// p = (x - r)^2 q + (x - r) p'(r) + p(r) where r is nearly the place where p is smallest: with a bit of q,
/// the rest is a square and a number, and what is left of q keeps away from 0 there.
std::optional<ex> form_beside(const numeric& r, const Coefficients& c, const GiNaC::symbol& x,
                              const Interval& range, int depth) {
  const ex p = in(c, x), height = p.subs(x == r), slope = p.diff(x).subs(x == r);
  const ex q = GiNaC::quo((p - slope * (x - r) - height).expand(), GiNaC::pow(x - r, 2).expand(), x);
  if (!height.info(GiNaC::info_flags::positive)) return std::nullopt;
  if (const auto form = slope.is_zero() ? rational_form(q, x, range, depth + 1) : std::nullopt)
    return GiNaC::pow(x - r, 2) * *form + height;
  for (const int parts : {1, 16, 256, 4096}) {
    const ex bit = numeric(1, parts), number = height - slope * slope / (4 * bit);
    if (!number.info(GiNaC::info_flags::positive)) return std::nullopt;
    const ex left = (q - bit).expand(), square = bit * GiNaC::pow(x - r + slope / (2 * bit), 2);
    const auto of_left = left.info(GiNaC::info_flags::positive) ? Coefficients{} : coefficients(left, x);
    const auto form = !of_left              ? std::nullopt
                      : of_left->empty()    ? std::optional(left)
                      : of_left->size() < 2 ? std::nullopt
                                            : form_without_squares(*of_left, x, range, depth + 1);
    if (form) return GiNaC::pow(x - r, 2) * *form + square + number;
  }
  return std::nullopt;
}

/// Of x², if there are no odd powers.
std::optional<ex> form_in_square(const Coefficients& c, const GiNaC::symbol& x, int depth) {
  Coefficients even;
  for (std::size_t k = 0; k < c.size(); ++k)
    if (k % 2 == 0)
      even.push_back(c[k]);
    else if (!c[k].is_zero())
      return std::nullopt;
  const GiNaC::realsymbol t("t");
  const auto form = form_without_squares(even, t, {{0, 0, true}, {0, +1, false}}, depth + 1);
  return form ? std::optional<ex>(form->subs(t == GiNaC::pow(x, 2))) : std::nullopt;
}

/// What has no factor twice.
std::optional<ex> form_without_squares(const Coefficients& c, const GiNaC::symbol& x, const Interval& range,
                                       int depth) {
  constexpr int deepest = 2;
  if (const auto form = form_at_once(c, x, range)) return form;
  if (depth == deepest || c.size() < 3) return std::nullopt;
  const bool is_everywhere = range.low.infinite != 0 && range.high.infinite != 0;
  if (const auto form = is_everywhere ? form_in_square(c, x, depth) : std::nullopt) return form;
  const double place = lowest(c, range);
  if (!(std::fabs(place) < 1e6) || !(value_at(c, place) > 0)) return std::nullopt;
  for (const int parts : {60, 10'000})
    if (const auto form = form_beside(numeric(std::lround(place * parts), parts), c, x, range, depth))
      return form;
  return std::nullopt;
}

std::optional<ex> rational_form(const ex& polynomial, const GiNaC::symbol& x, const Interval& range,
                                int depth) {
  const auto c = coefficients(polynomial, x);
  if (!c || c->size() < 2) return std::nullopt;
  const ex product = GiNaC::factor(in(*c, x));
  ex squares = 1, rest = 1;
  const ex factors = is_a<GiNaC::mul>(product) ? product : ex(GiNaC::lst{product});
  for (const ex& f : factors) {
    const bool is_power = is_a<GiNaC::power>(f);
    const int n = is_power ? ex_to<numeric>(f.op(1)).to_int() : 1;
    squares *= is_power ? GiNaC::pow(f.op(0), n - n % 2) : ex(1);
    rest *= !is_power ? f : n % 2 != 0 ? f.op(0) : ex(1);
  }
  if (is_a<numeric>(rest))
    return rest.info(GiNaC::info_flags::positive) ? std::optional(product) : std::nullopt;
  const auto form = form_without_squares(*coefficients(rest, x), x, range, depth);
  return form ? std::optional<ex>(squares * *form) : std::nullopt;
}

End divided(const End& end, const ex& by) {
  return end.infinite == 0 ? End{end.value / by, 0, end.closed} : end;
}

}  // namespace

std::optional<ex> positive_form(const ex& polynomial, const GiNaC::symbol& x, const Interval& range) {
  if (const auto form = rational_form(polynomial, x, range)) return form;
  if (coefficients(polynomial, x)) return std::nullopt;
  for (const int n : {2, 3, 5, 6}) {
    const ex root = GiNaC::sqrt(ex(n));
    const Interval scaled{divided(range.low, root), divided(range.high, root)};
    for (const ex& times : {ex(1), root}) {
      const auto form = rational_form((times * polynomial.subs(x == root * x)).expand(), x, scaled);
      if (form) return form->subs(x == x / root) / times;
    }
  }
  return std::nullopt;
}

}  // namespace rederive
