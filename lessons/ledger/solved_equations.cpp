// Equations that are assumed, solved for one symbol.
#include <fmt/format.h>

#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/solutions.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/periods.hpp>
#include <lessons/ledger/solved_equations.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// Whether a factor is nowhere 0 where the equation has a value and its rest is 0, so that one may divide by
/// it.
bool may_divide(const ex& factor, const ex& rest, const std::vector<ex>& divided_by, const Symbols& symbols) {
  const auto is_apart = [&](const ex& part) {
    const ex f = GiNaC::is_a<GiNaC::power>(part) ? part.op(0) : part;
    if (sign_of(f, symbols) != 0) return true;
    for (const ex& divisor : divided_by)
      if ((divisor / f).normal().denom().is_equal(1)) return true;
    for (const std::string& name : names_in(f)) {  // f = 0 says what that one is
      const ex &symbol = symbols[name], polynomial = f.expand();
      if (!polynomial.is_polynomial(symbol) || polynomial.degree(symbol) != 1) continue;
      const ex slope = polynomial.coeff(symbol, 1);
      if (GiNaC::is_a<GiNaC::numeric>(slope))
        return sign_of(rest.subs(symbol == -polynomial.coeff(symbol, 0) / slope), symbols) != 0;
    }
    return false;
  };
  if (sign_of(factor, symbols) != 0 || sign_of(rest, symbols) != 0) return true;
  const ex parts = GiNaC::factor(factor);
  if (!GiNaC::is_a<GiNaC::mul>(parts)) return is_apart(parts);
  return std::all_of(parts.begin(), parts.end(), is_apart);
}

/// Its root up to a sign: without the sign of a root where it is a square.
ex root_of(const ex& square) {
  const GiNaC::symbol number("pi");
  ex root = 1, rest = 1;
  const ex product = GiNaC::factor(square.subs(GiNaC::Pi == number));
  const auto take = [&](const ex& part) {
    const bool is_even = GiNaC::is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::even);
    (is_even ? root : rest) *= is_even ? GiNaC::pow(part.op(0), part.op(1) / 2) : part;
  };
  if (GiNaC::is_a<GiNaC::mul>(product))
    std::for_each(product.begin(), product.end(), take);
  else
    take(product);
  return (root * GiNaC::sqrt(rest.expand())).subs(number == GiNaC::Pi);
}

/// "x = ..." of a x^2 + b x + c = 0; nothing where that would take names that no user may type.
std::vector<std::string> quadratic_roots(const std::string& name, const ex& a, const ex& b, const ex& c,
                                         const Symbols& symbols) {
  for (const std::string& other : names_in(a + b + c))
    if (other.starts_with("excess_")) return {};
  if (is_nonnegative((4 * a * c - b * b).expand(), symbols))
    return {};  // no real root, or one at a few points
  std::vector<std::string> result;
  const ex root = root_of((b * b - 4 * a * c).expand());
  for (const int sign : {1, -1}) {
    const ex value = ((-b + sign * root) / (2 * a)).expand();
    result.push_back(name + " = " + print(value, Notation::plain, symbols));
  }
  if (result[0] == result[1]) result.pop_back();
  return result;
}

/// An equation that has no symbol alone: solved for one that is not small, in which it is linear, or the
/// power of one; better for one that may be anything. Of a square there are two solutions, if that one may be
/// positive and negative; and of a quadratic equation.
std::optional<Given> solved_for_one(const ex& residual, const std::vector<ex>& divided_by,
                                    const std::string& text, const Symbols& symbols,
                                    const std::vector<std::string>& small) {
  const ex polynomial = residual.normal().numer().expand();
  std::string of_either_sign;
  std::vector<std::string> roots;
  for (const bool is_free : {true, false})
    for (const std::string& name : names_in(polynomial)) {
      const ex& symbol = symbols[name];
      const std::string& range = symbols.find(name)->range;
      const bool is_wanted = (range == all_numbers) == is_free && !name.starts_with("excess_") &&
                             std::count(small.begin(), small.end(), name) == 0;
      if (!is_wanted || !polynomial.is_polynomial(symbol)) continue;
      const int n = polynomial.degree(symbol);
      const ex slope = polynomial.coeff(symbol, n), rest = polynomial.coeff(symbol, 0);
      const bool is_power = (polynomial - slope * GiNaC::pow(symbol, n) - rest).expand().is_zero();
      if (!is_power && n == 2 && sign_of(slope, symbols) != 0 && roots.empty())
        roots = quadratic_roots(name, slope, polynomial.coeff(symbol, 1), rest, symbols);
      if (!is_power || !may_divide(slope, rest, divided_by, symbols)) continue;
      const ex root = GiNaC::pow(-rest / slope, GiNaC::numeric(1) / n);
      if (n == 1 || is_nonnegative(symbol, symbols)) return Given{symbol, root};
      if (n % 2 == 0 && is_nonnegative(-symbol, symbols)) return Given{symbol, -root};
      if (n % 2 == 0 && of_either_sign.empty()) of_either_sign = name;
    }
  if (of_either_sign.empty() && roots.empty()) return std::nullopt;
  if (of_either_sign.empty())
    throw SeveralSolutions(fmt::format("the assumption '{}' has two solutions: assume \"{}\" as well", text,
                                       fmt::join(roots, "\" or \"")),
                           roots);
  throw SeveralSolutions("the assumption '" + text + "' says what " + of_either_sign +
                             " is, but for its sign: assume \"" + of_either_sign + " > 0\" or \"" +
                             of_either_sign + " < 0\" as well",
                         {of_either_sign + " >= 0", of_either_sign + " <= 0"});
}

/// Assumptions of which each leaves one of the solutions.
std::vector<std::string> choices(const std::string& name, const std::vector<ex>& values,
                                 const Symbols& symbols) {
  const Interval range = parse_range(symbols.find(name)->range);
  const bool is_whole = range.low.infinite != 0 && range.high.infinite != 0;
  if (is_whole && values.size() == 2 && compare(values[0], 0) < 0 && compare(values[1], 0) > 0)
    return {name + " > 0", name + " < 0"};
  std::vector<std::string> result;
  for (const ex& value : values) result.push_back(name + " = " + print(value, Notation::plain, symbols));
  return result;
}

/// An equation of one symbol that holds for one of its values only.
std::optional<Given> only_solution(const ex& residual, const std::string& text, const Symbols& symbols) {
  const auto names = names_in(residual);
  const auto values = solutions(residual, symbols);
  if (!values) return std::nullopt;
  if (values->empty()) contradicts(text);
  const std::string& name = *names.begin();
  if (values->size() > 1 && name.starts_with("excess_")) refuse(text);
  if (values->size() > 1) {
    const auto each = choices(name, *values, symbols);
    throw SeveralSolutions(fmt::format("the assumption '{}' holds for more than one value of {} in its range "
                                       "{}: assume \"{}\" as well",
                                       text, name, symbols.find(name)->range, fmt::join(each, "\" or \"")),
                           each);
  }
  return Given{symbols[name], values->front()};
}

/// The angle of a tangent, if it is between -pi/2 and pi/2, and not small.
std::optional<Given> solved_for_angle(const Sides& sides, const Symbols& symbols,
                                      const std::vector<std::string>& small) {
  for (const auto& [tangent, value] :
       {std::pair(sides.left, sides.right), std::pair(sides.right, sides.left)}) {
    if (name_of(tangent) != "tan" || !GiNaC::is_a<GiNaC::symbol>(tangent.op(0))) continue;
    const ex angle = tangent.op(0);
    const Symbol* symbol = symbols.find(angle);
    const Interval range = parse_range(symbol->range);
    if (value.has(angle) || std::count(small.begin(), small.end(), symbol->name) > 0) continue;
    if (range.low.infinite != 0 || compare(range.low.value, -GiNaC::Pi / 2) < 0) continue;
    if (range.high.infinite != 0 || compare(range.high.value, GiNaC::Pi / 2) > 0) continue;
    return Given{angle, GiNaC::atan(value)};
  }
  return std::nullopt;
}

/// Of each factor what it says of one symbol: "x = 0" and "y = 1" of x*y = x. Nothing where one says nothing.
std::vector<std::string> solved_by_factors(const ex& residual, const std::vector<ex>& divided_by,
                                           const std::string& text, const Context& context,
                                           const std::vector<std::string>& small) {
  const Symbols& symbols = context.symbols;
  const ex product = GiNaC::factor(residual.normal().numer());
  std::vector<std::string> result;
  if (!GiNaC::is_a<GiNaC::mul>(product)) return result;
  for (const ex& part : product) {
    const ex factor = GiNaC::is_a<GiNaC::power>(part) ? part.op(0) : part;
    if (sign_of(factor, symbols) != 0) continue;
    try {
      auto given = only_solution(factor, text, symbols);
      if (!given) given = solved_for_one(factor, divided_by, text, symbols, small);
      if (!given || symbols.find(given->name)->name.starts_with("excess_")) return {};
      const auto words = [&](const ex& e) { return print(e, Notation::plain, symbols); };
      const std::string known = without_excess(words(factor) + " = 0", context.comparisons, symbols);
      result.push_back(known == words(factor) + " = 0" ? words(given->name) + " = " + words(given->value)
                                                       : known);
    } catch (const SeveralSolutions& solutions) {
      for (const std::string& one : solutions.each)
        if (one.find(" = ") == std::string::npos) return {};  // no more than a sign
      result.insert(result.end(), solutions.each.begin(), solutions.each.end());
    } catch (const Contradiction&) {  // it is never 0
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

}  // namespace

std::optional<Given> solved(const Sides& sides, const Assumed& equation, const Context& context,
                            const std::vector<std::string>& small) {
  const Symbols& symbols = context.symbols;
  std::vector<ex> divided_by;
  for (const Tree& side : equation.relation.sides)
    for (const ex& divisor : divisors(side, symbols))
      divided_by.push_back(put_in(divisor, context.put_in_at_once(true)));
  const Sides inner = unwrapped(sides, symbols);
  const ex residual = sides.left - sides.right;
  auto each = same_turns(sides, context);
  const auto names = names_in(residual);
  const auto is_compared = [](const std::string& name) { return name.starts_with("excess_"); };
  if (std::any_of(names.begin(), names.end(), is_compared))  // what is compared stays free
    if (auto given = solved_for_angle(sides, symbols, small)) return given;
  for (const ex& way : {residual, inner.left - inner.right}) {
    if (!each.empty()) break;
    if (auto given = only_solution(way, equation.text, symbols)) return given;
    if (auto given = solved_for_one(way, divided_by, equation.text, symbols, small)) return given;
  }
  if (each.empty()) each = solved_by_factors(residual, divided_by, equation.text, context, small);
  if (each.empty()) return std::nullopt;
  throw SeveralSolutions(fmt::format("the assumption '{}' has several solutions: assume \"{}\" "
                                     "as well",
                                     equation.text, fmt::join(each, "\" or \"")),
                         each);
}

}  // namespace rederive
