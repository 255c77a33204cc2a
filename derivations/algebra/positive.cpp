#include <algorithm>
#include <cmath>
#include <derivations/algebra/positive.hpp>
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
  while (std::any_of(c->begin(), c->end(), [](const numeric& n) { return n.is_negative(); })) {
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

/// A rational number at the end of a range, or a bit outside of it.
numeric rational_end(const End& end, int outward) {
  if (is_a<numeric>(end.value) && ex_to<numeric>(end.value).is_rational()) return ex_to<numeric>(end.value);
  const double value = ex_to<numeric>(end.value.evalf()).to_double() * 1e6;
  if (!(std::fabs(value) < 1e12)) throw std::domain_error("no end to calculate with");
  return numeric(std::lround(value) + 2 * outward, 1'000'000);
}

}  // namespace

std::optional<ex> positive_form(const ex& polynomial, const GiNaC::symbol& x, const Interval& range) {
  const auto c = coefficients(polynomial, x);
  if (!c || c->size() < 2) return std::nullopt;
  const bool below = range.low.infinite == 0, above = range.high.infinite == 0;
  if (below && above) return between(in(*c, x), x, rational_end(range.low, -1), rational_end(range.high, +1));
  if (!below && !above) return everywhere(*c, x);
  const GiNaC::realsymbol t("t");
  const ex end = below ? rational_end(range.low, -1) : rational_end(range.high, +1);
  const auto moved = coefficients(in(*c, below ? end + t : end - t), t);
  return moved ? on_ray(*moved, below ? x - end : end - x) : std::nullopt;
}

}  // namespace rederive
