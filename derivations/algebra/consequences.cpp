#include <algorithm>
#include <derivations/algebra/cofactors.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/vanish.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::numeric;

namespace {

using Links = std::vector<Asked>;

/// What it divides by are numbers: it has a value where its functions have one.
bool is_whole(const ex& e) { return !has_symbol(e.denom()); }

// ---- sums of links with numbers for factors

/// A sum by its terms without their numbers; a sum of columns with such factors.
using Vector = std::map<ex, numeric, GiNaC::ex_is_less>;

Vector vector_of(const ex& e) {
  Vector result;
  const ex sum = e.expand(), terms = is_a<GiNaC::add>(sum) ? sum : ex(GiNaC::lst{sum});
  for (const ex& term : terms) {
    const ex last = is_a<GiNaC::mul>(term) ? term.op(term.nops() - 1) : term;
    const numeric number = is_a<numeric>(last) ? ex_to<numeric>(last) : numeric(1);
    if (!number.is_zero()) result[term / number] += number;
  }
  return result;
}

void add(Vector& to, const Vector& from, const numeric& times) {
  for (const auto& [term, number] : from)
    if ((to[term] += times * number).is_zero()) to.erase(term);
}

/// Numbers with which the columns add up to the target: 0 for a column that those before it make superfluous.
std::optional<std::vector<numeric>> combination(const ex& target, const std::vector<ex>& columns) {
  struct Row {
    Vector rest, of_columns;
  };
  std::vector<Row> rows;
  const auto reduce = [&](Row& row) {
    for (const Row& known : rows) {
      const auto& [pivot, number] = *known.rest.begin();
      if (!row.rest.contains(pivot)) continue;
      const numeric times = -row.rest[pivot] / number;
      add(row.rest, known.rest, times), add(row.of_columns, known.of_columns, times);
    }
  };
  for (std::size_t k = 0; k < columns.size(); ++k) {
    Row row{vector_of(columns[k]), {{numeric(static_cast<long>(k)), 1}}};
    reduce(row);
    if (!row.rest.empty()) rows.push_back(row);
  }
  Row last{vector_of(target), {}};
  reduce(last);
  if (!last.rest.empty()) return std::nullopt;
  std::vector<numeric> result(columns.size());
  for (const auto& [column, number] : last.of_columns)
    result[static_cast<std::size_t>(ex_to<numeric>(column).to_int())] = -number;
  return result;
}

/// The target as a sum of equations, of some inequalities and of a number.
std::optional<Consequence> by_numbers(const Asked& target, const Links& links,
                                      const std::vector<std::size_t>& inequalities) {
  const bool is_equation = target.claim == Claim::zero;
  std::vector<std::size_t> chosen;
  for (std::size_t k = 0; k < links.size(); ++k)
    if (links[k].claim == Claim::zero) chosen.push_back(k);
  const std::size_t equations = chosen.size();
  chosen.insert(chosen.end(), inequalities.begin(), inequalities.end());
  std::vector<ex> columns;
  for (const std::size_t k : chosen) columns.push_back(links[k].residual);
  if (!is_equation) columns.emplace_back(1);
  const auto numbers = combination(target.residual, columns);
  if (!numbers) return std::nullopt;
  Consequence result;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    if (!(*numbers)[k].is_zero()) result.terms.push_back({(*numbers)[k], {chosen[k]}});
  if (is_equation) return result;
  result.more = numbers->back();
  bool is_strict = numbers->back().is_positive();
  for (std::size_t k = equations; k <= chosen.size(); ++k) {
    const numeric& number = (*numbers)[k];
    if (number.is_negative()) return std::nullopt;
    is_strict =
        is_strict || (number.is_positive() && k < chosen.size() && links[chosen[k]].claim == Claim::positive);
  }
  return is_strict || target.claim == Claim::not_negative ? std::optional(result) : std::nullopt;
}

/// None of the inequalities, each of them, and each two and three.
std::vector<std::vector<std::size_t>> some_inequalities(const Links& links) {
  std::vector<std::vector<std::size_t>> result{{}};
  for (std::size_t first = 0, size = 0; size < 3; ++size) {  // those of one more than the last ones
    const std::size_t last = result.size();
    for (; first < last; ++first)
      for (std::size_t k = result[first].empty() ? 0 : result[first].back() + 1; k < links.size(); ++k) {
        if (links[k].claim == Claim::zero) continue;
        result.push_back(result[first]);
        result.back().push_back(k);
      }
    if (result.size() > 100) break;
  }
  return result;
}

/// r = 0, for r >= 0 and -r >= 0 are sums of inequalities, and -r² is the product of these.
std::optional<Consequence> by_both_sides(const ex& r, const Links& links) {
  std::vector<Consequence> sums;
  for (const ex& side : {r, ex(-r)})
    for (const auto& chosen : some_inequalities(links)) {
      const auto sum = by_numbers({side, Claim::not_negative}, links, chosen);
      const bool fits = sum && sum->more.is_zero() &&
                        std::all_of(sum->terms.begin(), sum->terms.end(), [&](const Summand& term) {
                          return links[term.links[0]].claim != Claim::zero;
                        });
      if (!fits) continue;
      sums.push_back(*sum);
      break;
    }
  if (sums.size() != 2) return std::nullopt;
  Consequence result{{}, 0, 1, true};
  for (const Summand& a : sums[0].terms)
    for (const Summand& b : sums[1].terms)
      result.terms.push_back({a.factor * b.factor, {a.links[0], b.links[0]}});
  return result;
}

// ---- with the equations solved for symbols

/// The target, or the target without an inequality, divided by the equations one after another; what is left
/// over is not negative.
std::optional<Consequence> by_division(const Asked& target, const Links& links,
                                       std::optional<std::size_t> inequality, const Symbols& symbols) {
  std::vector<std::size_t> chosen;
  std::vector<ex> equations;
  for (std::size_t k = 0; k < links.size(); ++k)
    if (links[k].claim == Claim::zero) chosen.push_back(k), equations.push_back(links[k].residual.expand());
  const auto solution = equations.empty() ? std::nullopt : solved(equations, symbols);
  if (!solution) return std::nullopt;
  ex rest = inequality ? target.residual - links[*inequality].residual : target.residual;
  std::vector<ex> factors(chosen.size());
  for (const auto& [name, value] : *solution) {
    const ex &symbol = symbols[name], divisor = symbol - value;
    const ex next = rest.subs(symbol == value, GiNaC::subs_options::no_pattern).expand();
    const auto numbers = combination(divisor, equations);
    if (!numbers || !rest.is_polynomial(symbol)) return std::nullopt;
    const ex quotient = ((rest - next) / divisor).normal();
    if (!is_whole(quotient)) return std::nullopt;
    for (std::size_t k = 0; k < chosen.size(); ++k) factors[k] += quotient * (*numbers)[k];
    rest = next;
  }
  Consequence result;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    if (!factors[k].expand().is_zero()) result.terms.push_back({factors[k].expand(), {chosen[k]}});
  if (inequality) result.terms.push_back({1, {*inequality}});
  result.more = rest;
  const bool is_strict =
      sign_of(rest, symbols) > 0 || (inequality && links[*inequality].claim == Claim::positive);
  const bool fits = target.claim == Claim::zero
                        ? rest.is_zero()
                        : is_nonnegative(rest, symbols) && (is_strict || target.claim == Claim::not_negative);
  return fits ? std::optional(result) : std::nullopt;
}

// ---- one link, with a factor

/// above/below, with a positive `below`; and the sign of `above` where it is not 0, 0 where it may be either.
struct Ratio {
  ex above = 1, below = 1;
  int sign = 0;
};

/// left/right where that is a product without poles.
std::optional<Ratio> ratio_of(const ex& left, const ex& right, const Symbols& symbols) {
  const auto parts = checked_quotient(left, right, symbols);
  if (!parts) return std::nullopt;
  Ratio ratio;
  ratio.sign = assess(*parts, {}, symbols).sign;
  for (const auto& [part, exponent] : *parts) {
    const int sign = sign_of(part, symbols);
    if (exponent.is_positive()) ratio.above *= GiNaC::pow(part, exponent);
    if (exponent.is_negative() && sign == 0) return std::nullopt;
    if (sign_of(hidden_divisor(part), symbols) == 0) return std::nullopt;
    if (exponent.is_negative()) ratio.below *= GiNaC::pow(sign * part, -exponent);
    if (exponent.is_negative() && exponent.is_odd()) ratio.above *= sign;
  }
  return ratio;
}

/// r = 0, for -r² is not negative: it is that link with a factor, or with more.
std::optional<Consequence> by_square(const ex& r, const Links& links, std::size_t k, const Symbols& symbols) {
  const ex square = -GiNaC::pow(r, 2);
  const auto& [l, claim] = links[k];
  const auto ratio = ratio_of(square, l, symbols);
  if (ratio && (ratio->sign > 0 || claim == Claim::zero))
    return Consequence{{{ratio->above, {k}}}, 0, ratio->below, true};
  for (const int sign : {1, -1})
    for (const numeric& times : {numeric(1), numeric(1, 4)}) {
      const ex more = (times * square - sign * l).expand();
      if ((sign > 0 || claim == Claim::zero) && is_whole(more) && is_nonnegative(more, symbols))
        return Consequence{{{sign, {k}}}, more, times, true};
    }
  if (is_nonnegative(-l, symbols) && vanishes(GiNaC::pow(l, 2) + square, symbols))
    return Consequence{{{-l, {k}}}, 0, 1, true};
  return std::nullopt;
}

/// r >= 0, or -r² >= 0, as a product of two inequalities with a factor.
std::optional<Consequence> by_two(const Asked& target, const Links& links, std::size_t k, std::size_t other,
                                  const Symbols& symbols) {
  const bool squared = target.claim == Claim::zero, fits = target.claim != Claim::positive &&
                                                           links[k].claim != Claim::zero &&
                                                           links[other].claim != Claim::zero;
  const ex goal = squared ? ex(-GiNaC::pow(target.residual, 2)) : target.residual;
  const auto ratio = fits ? ratio_of(goal, links[k].residual * links[other].residual, symbols) : std::nullopt;
  if (!ratio || ratio->sign <= 0) return std::nullopt;
  return Consequence{{{ratio->above, {other, k}}}, 0, ratio->below, squared};
}

/// Σ c_n l^n as terms, if l can be solved for a symbol and the target is such a sum of what is not negative.
std::optional<Consequence> by_powers(const Asked& target, const Links& links, std::size_t k,
                                     const Symbols& symbols) {
  const ex& l = links[k].residual;
  const GiNaC::symbol t("$t");
  for (const std::string& name : names_in(l)) {
    const ex& x = symbols[name];
    if (!l.is_polynomial(x) || l.expand().degree(x) != 1 || !is_a<numeric>(l.expand().coeff(x, 1))) continue;
    const ex solved = (t - l.expand().coeff(x, 0)) / l.expand().coeff(x, 1);
    const ex powers = target.residual.subs(x == solved, GiNaC::subs_options::no_pattern).expand();
    if (!powers.is_polynomial(t) || powers.degree(t) > 8) continue;
    Consequence result;
    bool fits = true, is_strict = target.claim == Claim::not_negative;
    for (int n = powers.ldegree(t); n <= powers.degree(t); ++n) {
      const ex factor = powers.coeff(t, n);
      if (factor.is_zero()) continue;
      fits = fits && is_whole(factor) && is_nonnegative(factor, symbols);
      is_strict = is_strict || (links[k].claim == Claim::positive && sign_of(factor, symbols) > 0);
      if (n == 0)
        result.more = factor;
      else
        result.terms.push_back({factor, std::vector<std::size_t>(static_cast<std::size_t>(n), k)});
    }
    if (fits && is_strict) return result;
  }
  return std::nullopt;
}

/// From one link alone.
std::optional<Consequence> by_one(const Asked& target, const Links& links, std::size_t k,
                                  const Symbols& symbols) {
  const auto& [r, claim] = target;
  const Asked& link = links[k];
  if (claim == Claim::zero) return by_square(r, links, k, symbols);
  const auto ratio = ratio_of(r, link.residual, symbols);
  if (claim == Claim::not_negative && ratio && (ratio->sign > 0 || link.claim == Claim::zero))
    return Consequence{{{ratio->above, {k}}}, 0, ratio->below};
  if (claim == Claim::not_negative)
    if (const auto square = by_square(r, links, k, symbols)) return square;
  if (link.claim == Claim::zero) return std::nullopt;
  if (const auto powers = by_powers(target, links, k, symbols)) return powers;
  const auto turned = ratio_of(link.residual, r, symbols);
  const bool fits = turned && turned->sign > 0 && claim == Claim::positive && link.claim == Claim::positive;
  return fits ? std::optional(Consequence{{{turned->below, {k}}}, 0, turned->above}) : std::nullopt;
}

using Parts = std::set<ex, GiNaC::ex_is_less>;

/// Roots and functions that may have no value.
void collect_doubtful(const ex& e, Parts& parts, const Symbols& symbols) {
  static const std::set<std::string> entire{"sin",  "cos",  "exp",   "sinh", "cosh",
                                            "tanh", "atan", "asinh", "abs"};
  for (const ex& part : e) collect_doubtful(part, parts, symbols);
  const bool is_power = is_a<GiNaC::power>(e) && !e.op(1).info(GiNaC::info_flags::nonnegint);
  if (is_power ? sign_of(e.op(0), symbols) <= 0 : is_a<GiNaC::function>(e) && !entire.contains(name_of(e)))
    parts.insert(e);
}

Parts doubtful_parts(const Links& links, const std::vector<ex>& divisors, const Symbols& symbols) {
  Parts parts;
  for (const Asked& link : links) collect_doubtful(link.residual, parts, symbols);
  for (const ex& divisor : divisors)
    if (sign_of(divisor, symbols) == 0) parts.insert(divisor);
  return parts;
}

}  // namespace

bool have_values_together(const Links& left, const Links& right, const Residuals& r, const Symbols& symbols) {
  const Parts of_left = doubtful_parts(left, r.left_divisors, symbols),
              of_right = doubtful_parts(right, r.right_divisors, symbols);
  const auto is_granted = [&](const Parts& parts, const Parts& others, const Links& by) {
    return std::all_of(parts.begin(), parts.end(), [&](const ex& part) {
      const bool is_reciprocal = is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::negint);
      const ex divisor = is_reciprocal ? part.op(0) : part;
      return others.contains(part) || others.contains(divisor) ||
             (is_a<GiNaC::symbol>(divisor) && exclude_zero(by, divisor, symbols));
    });
  };
  return is_granted(of_left, of_right, right) && is_granted(of_right, of_left, left);
}

std::optional<Consequence> consequence(const Asked& target, const Links& links,
                                       const std::vector<ex>& divisors, const Symbols& symbols) {
  const auto is_shown = [&](const std::optional<Consequence>& why) {
    return why && shows(*why, target, links, divisors, symbols);
  };
  const bool is_equation = target.claim == Claim::zero;
  for (const auto& chosen : some_inequalities(links)) {
    if (is_equation && !chosen.empty()) break;
    if (const auto found = by_numbers(target, links, chosen); is_shown(found)) return found;
  }
  if (const auto found = by_elimination(target, links, divisors, symbols); is_shown(found)) return found;
  std::vector<std::optional<std::size_t>> bases{std::nullopt};
  for (std::size_t k = 0; k < links.size(); ++k)
    if (links[k].claim != Claim::zero && !is_equation) bases.emplace_back(k);
  for (std::size_t k = 0; k < links.size(); ++k) {
    if (const auto found = by_one(target, links, k, symbols); is_shown(found)) return found;
    for (std::size_t other = 0; other < k; ++other)
      if (const auto found = by_two(target, links, k, other, symbols); is_shown(found)) return found;
  }
  if (is_equation)
    if (const auto found = by_both_sides(target.residual, links); is_shown(found)) return found;
  for (const auto& base : bases)
    if (const auto found = by_division(target, links, base, symbols); is_shown(found)) return found;
  return std::nullopt;
}

}  // namespace rederive
