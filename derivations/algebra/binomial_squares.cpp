#include <algorithm>
#include <cmath>
#include <derivations/algebra/binomial_squares.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/linear_program.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/sample.hpp>
#include <map>
#include <numeric>

namespace rederive {

using cln::cl_RA;
using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

constexpr std::size_t most_units = 4, most_monomials = 45, most_columns = 700;
constexpr int highest_degree = 12;

using Exponents = std::vector<int>;
using Polynomial = std::map<Exponents, cl_RA>;

/// What a polynomial is written in: x, its root, its square or a function of it, not negative or of either
/// sign.
struct Unit {
  ex value;
  bool may_be_negative, may_be_zero;
};

struct Written {
  std::vector<Unit> units;
  Polynomial polynomial;
};

bool is_root(const ex& e) { return is_a<GiNaC::power>(e) && e.op(1).info(GiNaC::info_flags::rational); }

/// Symbols, functions and exponents in units of 1/2 of each; nothing where it is no polynomial in them.
std::optional<Written> written(const ex& sum, const Symbols& symbols) {
  std::vector<ex> bases;
  std::vector<std::pair<std::map<std::size_t, numeric>, numeric>> terms;
  for (const ex& term : sum) {
    auto& [exponents, factor] = terms.emplace_back(std::map<std::size_t, numeric>{}, numeric(1));
    const ex factors = is_a<GiNaC::mul>(term) ? term : ex(GiNaC::lst{term});
    for (const ex& f : factors) {
      if (is_a<numeric>(f)) {
        factor = factor * ex_to<numeric>(f);
        continue;
      }
      const ex base = is_root(f) ? f.op(0) : f;
      if (!is_a<GiNaC::symbol>(base) && !is_a<GiNaC::function>(base)) return std::nullopt;
      const auto is_it = [&](const ex& other) { return other.is_equal(base); };
      const auto place = std::find_if(bases.begin(), bases.end(), is_it) - bases.begin();
      if (static_cast<std::size_t>(place) == bases.size()) bases.push_back(base);
      exponents[place] = is_root(f) ? ex_to<numeric>(f.op(1)) : numeric(1);
    }
    if (!factor.is_rational()) return std::nullopt;
  }
  if (bases.size() < 2 || bases.size() > most_units) return std::nullopt;
  Written result;
  for (std::size_t k = 0; k < bases.size(); ++k) {
    bool has_root = false, is_even = true;
    for (const auto& [exponents, factor] : terms)
      if (const auto found = exponents.find(k); found != exponents.end()) {
        if (found->second.denom() > 2) return std::nullopt;
        has_root = has_root || !found->second.is_integer(), is_even = is_even && found->second.is_even();
      }
    const bool is_positive = is_nonnegative(bases[k], symbols);
    const numeric power = has_root ? numeric(1, 2) : is_even ? numeric(2) : numeric(1);
    result.units.push_back(
        {GiNaC::pow(bases[k], power), !is_positive && power == 1, sign_of(bases[k], symbols) == 0});
    for (auto& [exponents, factor] : terms)
      if (exponents.contains(k)) exponents[k] = exponents[k] / power;
  }
  for (const auto& [exponents, factor] : terms) {
    Exponents whole(bases.size(), 0);
    for (const auto& [k, n] : exponents) {
      if (n.is_negative() || n > highest_degree) return std::nullopt;
      whole[k] = n.to_int();
    }
    result.polynomial[whole] = cln::the<cl_RA>(factor.to_cl_N());
  }
  return result;
}

int degree(const Exponents& e) { return std::accumulate(e.begin(), e.end(), 0); }

/// The one sign that it has at a few points; 0 where that is not one: most sums have either.
int seen_sign(const ex& sum, const Symbols& symbols) {
  constexpr int looked_at = 24;
  constexpr double nothing = 1e-9;
  const Points points(names_in(sum), symbols);
  int sign = 0;
  for (int k = 0; k < looked_at; ++k) {
    GiNaC::exmap at;
    for (const auto& [name, value] : points.at(k)) at[symbols[name]] = numeric(value);
    try {
      const ex value = sum.subs(at).evalf();
      if (!is_a<numeric>(value) || !ex_to<numeric>(value).is_real()) continue;
      const double height = ex_to<numeric>(value).to_double();
      if (!(std::fabs(height) > nothing)) continue;
      if (sign * height < 0) return 0;
      sign = height > 0 ? 1 : -1;
    } catch (const std::exception&) {  // a pole, or too large
    }
  }
  return sign;
}

Polynomial times(const Polynomial& a, const Polynomial& b) {
  Polynomial result;
  for (const auto& [e, factor] : a)
    for (const auto& [f, other] : b) {
      Exponents sum = e;
      for (std::size_t k = 0; k < e.size(); ++k) sum[k] += f[k];
      result[sum] = result[sum] + factor * other;
    }
  return result;
}

/// What is not negative because a unit keeps to its range, as 1 - sin x; or what is 0, as 1 - sin²x - cos²x.
struct Bound {
  Polynomial polynomial;
  ex value;
};

struct Bounds {
  std::vector<Bound> not_negative, zero;
};

Exponents only(std::size_t k, int n, std::size_t size) {
  Exponents e(size, 0);
  e[k] = n;
  return e;
}

Bounds bounds_of(const std::vector<Unit>& units, const Symbols& symbols) {
  Bounds bounds;
  const std::size_t n = units.size();
  const Exponents none(n, 0);
  for (std::size_t k = 0; k < n; ++k) {
    const ex& u = units[k].value;
    if (!is_a<GiNaC::symbol>(u) && !is_a<GiNaC::function>(u)) continue;
    const Interval range = interval_of(u, symbols);
    for (const int side : {1, -1}) {
      const End& end = side > 0 ? range.low : range.high;
      if (end.infinite != 0 || !end.value.info(GiNaC::info_flags::rational) ||
          (side > 0 && end.value.is_zero()))
        continue;
      const cl_RA at = cln::the<cl_RA>(ex_to<numeric>(end.value).to_cl_N());
      bounds.not_negative.push_back({{{only(k, 1, n), side}, {none, -side * at}}, side * (u - end.value)});
    }
    for (std::size_t j = 0; j < n; ++j) {
      const ex& v = units[j].value;
      const std::string first = name_of(u), second = name_of(v);
      const bool is_circle = first == "sin" && second == "cos",
                 is_hyperbola = first == "sinh" && second == "cosh";
      if ((is_circle || is_hyperbola) && u.op(0).is_equal(v.op(0)))
        bounds.zero.push_back({{{none, 1}, {only(k, 2, n), is_circle ? -1 : 1}, {only(j, 2, n), -1}}, 0});
    }
  }
  return bounds;
}

/// All with exponents between those of the polynomial, and of a degree between those; beside bounds, from 0
/// on, and with squares.
std::vector<Exponents> monomials_of(const Polynomial& polynomial, const Bounds& bounds) {
  const bool is_bounded = !bounds.not_negative.empty() || !bounds.zero.empty();
  Exponents low = polynomial.begin()->first, high = low;
  int least = degree(low), most = least;
  for (const auto& [e, factor] : polynomial) {
    least = std::min(least, degree(e)), most = std::max(most, degree(e));
    for (std::size_t k = 0; k < e.size(); ++k)
      low[k] = std::min(low[k], e[k]), high[k] = std::max(high[k], e[k]);
  }
  if (is_bounded) {
    least = 0, most = std::max(most, 2);
    for (std::size_t k = 0; k < low.size(); ++k) low[k] = 0, high[k] = std::max(high[k], 2);
  }
  std::vector<Exponents> result;
  for (Exponents e = low;;) {
    if (degree(e) >= least && degree(e) <= most) result.push_back(e);
    if (result.size() > most_monomials) return result;
    std::size_t k = 0;
    while (k < e.size() && e[k] == high[k]) e[k] = low[k], ++k;
    if (k == e.size()) return result;
    ++e[k];
  }
}

/// Whether no factor of a monomial may be negative.
bool is_positive(const Exponents& e, const std::vector<Unit>& units) {
  for (std::size_t k = 0; k < e.size(); ++k)
    if (units[k].may_be_negative && e[k] % 2 != 0) return false;
  return true;
}

bool is_never_zero(const Exponents& e, const std::vector<Unit>& units) {
  for (std::size_t k = 0; k < e.size(); ++k)
    if (units[k].may_be_zero && e[k] != 0) return false;
  return true;
}

ex product(const Exponents& e, const std::vector<Unit>& units) {
  ex result = 1;
  for (std::size_t k = 0; k < e.size(); ++k) result *= GiNaC::pow(units[k].value, e[k]);
  return result;
}

/// A term of the form, with what it is as a polynomial.
struct Part {
  ex value;
  Polynomial polynomial;
  bool is_never_zero = false;
};

/// m (u - r v)² of first = m u² and second = m v².
Part square(const Exponents& first, const Exponents& second, const cl_RA& r, const std::vector<Unit>& units) {
  Exponents common = first, u = first, v = first, middle = first;
  for (std::size_t k = 0; k < first.size(); ++k) {
    common[k] = std::min(first[k], second[k]), middle[k] = (first[k] + second[k]) / 2;
    u[k] = (first[k] - common[k]) / 2, v[k] = (second[k] - common[k]) / 2;
  }
  return {product(common, units) * GiNaC::pow(product(u, units) - numeric(r) * product(v, units), 2),
          {{first, 1}, {second, r * r}, {middle, -2 * r}}};
}

void add_squares(std::vector<Part>& parts, const std::vector<Exponents>& positive,
                 const std::vector<Unit>& units, const std::vector<cl_RA>& ratios) {
  for (std::size_t j = 0; j < positive.size(); ++j)
    for (std::size_t k = j + 1; k < positive.size(); ++k) {
      bool is_between = true;
      Exponents middle = positive[j];
      for (std::size_t n = 0; n < middle.size(); ++n) {
        is_between = is_between && (positive[j][n] + positive[k][n]) % 2 == 0;
        middle[n] = (positive[j][n] + positive[k][n]) / 2;
      }
      if (!is_between) continue;
      for (const cl_RA& r : ratios) {
        parts.push_back(square(positive[j], positive[k], r, units));
        if (!is_positive(middle, units)) parts.push_back(square(positive[j], positive[k], -r, units));
      }
    }
}

/// Monomials times one bound, or two; and what is 0, with either sign.
void add_bounds(std::vector<Part>& parts, const std::vector<Exponents>& monomials, const Bounds& bounds,
                const std::vector<Unit>& units) {
  for (const Exponents& e : monomials) {
    const Polynomial monomial{{e, 1}};
    for (const Bound& b : bounds.zero)
      for (const int sign : {1, -1}) parts.push_back({0, times({{e, sign}}, b.polynomial)});
    if (!is_positive(e, units)) continue;
    for (std::size_t j = 0; j < bounds.not_negative.size(); ++j) {
      const Bound& b = bounds.not_negative[j];
      const Polynomial once = times(monomial, b.polynomial);
      const ex value = product(e, units) * b.value;
      parts.push_back({value, once});
      for (std::size_t k = j; k < bounds.not_negative.size(); ++k)
        parts.push_back(
            {value * bounds.not_negative[k].value, times(once, bounds.not_negative[k].polynomial), false});
    }
  }
}

std::optional<ex> form(const Polynomial& polynomial, const std::vector<Unit>& units, const Bounds& bounds,
                       const std::vector<cl_RA>& ratios) {
  const std::vector<Exponents> monomials = monomials_of(polynomial, bounds);
  if (monomials.size() > most_monomials) return std::nullopt;
  std::map<Exponents, std::size_t> row;
  for (const Exponents& e : monomials) row.emplace(e, row.size());
  std::vector<Exponents> positive;
  std::vector<Part> parts;
  for (const Exponents& e : monomials)
    if (is_positive(e, units))
      positive.push_back(e), parts.push_back({product(e, units), {{e, 1}}, is_never_zero(e, units)});
  add_squares(parts, positive, units, ratios);
  add_bounds(parts, monomials, bounds, units);
  std::erase_if(parts, [&](const Part& part) {
    return std::any_of(part.polynomial.begin(), part.polynomial.end(),
                       [&](const auto& term) { return !row.contains(term.first); });
  });
  if (parts.size() > most_columns) return std::nullopt;
  LinearProgram program;
  program.sum.assign(monomials.size(), 0);
  for (const auto& [e, factor] : polynomial) program.sum[row.at(e)] = factor;
  for (const Part& part : parts) {
    std::vector<cl_RA>& column = program.columns.emplace_back(monomials.size(), 0);
    for (const auto& [e, factor] : part.polynomial) column[row.at(e)] = factor;
    program.gains.emplace_back(part.is_never_zero ? 1 : 0);
  }
  const auto solution = largest_solution(program);
  if (!solution) return std::nullopt;
  ex sum = 0;
  for (std::size_t k = 0; k < parts.size(); ++k) sum += numeric((*solution)[k]) * parts[k].value;
  return sum;
}

/// The sum of the units; and 1, where the terms of the polynomial are not all of one degree.
Polynomial sum_of_units(const Written& w) {
  Polynomial result;
  for (std::size_t k = 0; k < w.units.size(); ++k) result[only(k, 1, w.units.size())] = 1;
  const int n = degree(w.polynomial.begin()->first);
  if (std::any_of(w.polynomial.begin(), w.polynomial.end(),
                  [n](const auto& t) { return degree(t.first) != n; }))
    result[Exponents(w.units.size(), 0)] = 1;
  return result;
}

/// Whether the range shows that it is positive, not just not negative.
bool is_shown_positive(const ex& form, const Symbols& symbols) {
  const End low = interval_of(form, symbols).low;
  return low.infinite == 0 && (!low.closed || compare(low.value, 0) > 0);
}

/// Of what is not negative: the first form that shows that it is positive, if one does.
std::optional<ex> form_of(const Written& w, const Symbols& symbols) {
  std::optional<ex> weak;
  const auto is_enough = [&](const std::optional<ex>& found) {
    if (found && !weak) weak = found;
    return found && is_shown_positive(*found, symbols);
  };
  const cl_RA one = 1;
  const std::vector<cl_RA> ratios{1, 2, one / 2, 3, one / 3, 4, one / 4};
  for (const auto& [bounds, of_squares] :
       {std::pair<Bounds, std::vector<cl_RA>>{{}, {1}}, {bounds_of(w.units, symbols), {1}}, {{}, ratios}})
    if (const auto found = form(w.polynomial, w.units, bounds, of_squares); is_enough(found)) return found;
  if (weak || std::any_of(w.units.begin(), w.units.end(), [](const Unit& u) { return u.may_be_negative; }))
    return weak;
  const Polynomial factor = sum_of_units(w);
  ex divisor = 0;
  for (const auto& [e, one_more] : factor) divisor += product(e, w.units);
  Polynomial raised = w.polynomial;
  for (int n = 1; n <= 2; ++n) {
    raised = times(raised, factor);
    if (const auto found = form(raised, w.units, {}, {1})) return *found / GiNaC::pow(divisor, n);
  }
  return std::nullopt;
}

}  // namespace

std::optional<ex> form_of_binomial_squares(const ex& polynomial, const Symbols& symbols) {
  const ex sum = polynomial.expand();
  auto w = is_a<GiNaC::add>(sum) ? written(sum, symbols) : std::nullopt;
  const int sign = w ? seen_sign(sum, symbols) : 0;
  if (sign == 0) return std::nullopt;
  for (auto& [exponents, factor] : w->polynomial) factor = sign * factor;
  const auto found = form_of(*w, symbols);
  return found ? std::optional<ex>(sign * *found) : std::nullopt;
}

}  // namespace rederive
