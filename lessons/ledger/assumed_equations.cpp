#include <fmt/format.h>

#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/solutions.hpp>
#include <derivations/algebra/unwrap.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/witness.hpp>
#include <lessons/ledger/assumed.hpp>
#include <lessons/ledger/periods.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

const std::string any = "(-inf, inf)";

bool is_name(const Tree& tree) { return tree->kind == Node::Kind::symbol && tree->text != "pi"; }

/// The symbol that an equation says the value of, if any: alone on a side and not on the other, and nothing
/// stands for it yet. Of two symbols the one that is not small, or that may be anything, so that the range of
/// the other one stays.
std::optional<Given> read_given(const Tree& a, const Tree& b, const std::string& text, const Context& context,
                                const std::vector<std::string>& small) {
  const Symbols& symbols = context.symbols;
  const auto before = context.put_in_at_once(true);
  const auto is_small = [&](const Tree& tree) {
    return std::count(small.begin(), small.end(), tree->text) > 0;
  };
  const bool turn =
      is_name(a) && is_name(b) && (is_small(a) || (symbols.find(b->text)->range == any && !is_small(b)));
  for (const auto& [name, value] : {turn ? std::pair{b, a} : std::pair{a, b}, std::pair{b, a}}) {
    if (!is_name(name)) continue;
    const Given given = reading(text, [&] { return Given{lower(name, symbols), lower(value, symbols)}; });
    if (given.value.has(given.name)) continue;
    const bool is_new = put_in(given.name, before).is_equal(given.name);
    if (is_new && !put_in(given.value, before).has(given.name)) return given;
  }
  return {};
}

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

/// "x = ..." of a x^2 + b x + c = 0; nothing where that would take names that no user may type.
std::vector<std::string> quadratic_roots(const std::string& name, const ex& a, const ex& b, const ex& c,
                                         const Symbols& symbols) {
  for (const std::string& other : names_in(a + b + c))
    if (other.starts_with("excess_")) return {};
  std::vector<std::string> result;
  for (const int sign : {1, -1}) {
    const ex root = (-b + sign * GiNaC::sqrt((b * b - 4 * a * c).expand())) / (2 * a);
    result.push_back(name + " = " + print(root, Notation::plain, symbols));
  }
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
      const bool is_wanted = (range == any) == is_free && !name.starts_with("excess_") &&
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

/// Of each factor what it says of one symbol: "x = 0" and "y = 1" of x*y = x. Nothing where one says nothing.
std::vector<std::string> solved_by_factors(const ex& residual, const std::vector<ex>& divided_by,
                                           const std::string& text, const Symbols& symbols,
                                           const std::vector<std::string>& small) {
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
      result.push_back(print(given->name, Notation::plain, symbols) + " = " +
                       print(given->value, Notation::plain, symbols));
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

/// Of an equation whose sides are this, with what else is assumed put in: solved for one symbol; or without
/// the functions around its sides, as x^3 = y^3 or exp(x) = exp(y); or factor by factor.
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
  for (const ex& way : {residual, inner.left - inner.right}) {
    if (!each.empty()) break;
    if (auto given = only_solution(way, equation.text, symbols)) return given;
    if (auto given = solved_for_one(way, divided_by, equation.text, symbols, small)) return given;
  }
  if (each.empty()) each = solved_by_factors(residual, divided_by, equation.text, symbols, small);
  if (each.empty()) return std::nullopt;
  throw SeveralSolutions(fmt::format("the assumption '{}' has several solutions: assume \"{}\" "
                                     "as well",
                                     equation.text, fmt::join(each, "\" or \"")),
                         each);
}

/// What is solved for none, with what would help.
[[noreturn]] void refuse_equation(const ex& residual, const Assumed& equation) {
  const auto& sides = equation.relation.sides;
  const auto has = [](const Tree& side, const std::string& name) {
    std::set<std::string> names;
    return collect_names(side, names), names.contains(name);
  };
  for (const int k : {0, 1})
    if (is_name(sides[k]) && has(sides[1 - k], sides[k]->text))
      refuse(equation.text, sides[k]->text + " is on both sides");
  if (std::any_of(sides.begin(), sides.end(), is_name))
    throw BadInput(
        "the assumption '" + equation.text +
        "' goes round in a circle with the equations before it, or gives a second value to a symbol");
  const auto names = names_in(residual);
  if (names.size() != 1 || names.begin()->starts_with("excess_")) refuse(equation.text);
  const std::string& name = *names.begin();
  refuse(equation.text,
         "if it holds for one value of " + name + " only, say that one: \"" + name + " = ...\"");
}

void check_range(const Given& given, const std::vector<Given>& all, const Symbols& symbols) {
  const Interval range = parse_range(symbols.find(given.name)->range);
  const ex value = put_in(given.value, all);
  const auto is_beyond = [&](const End& end, int side) {
    if (end.infinite != 0) return false;
    const ex outside = side * (value - end.value);
    return end.closed ? sign_of(outside, symbols) > 0 : is_nonnegative(outside, symbols);
  };
  if (is_beyond(range.low, -1) || is_beyond(range.high, 1))
    throw Contradiction("the assumption on " + print(given.name, Notation::plain, symbols) +
                        " contradicts its range " + symbols.find(given.name)->range +
                        ", as declared or assumed");
}

/// What can be seen never to hold: without a value, or with one side always greater.
void check_equation(const Assumed& equation, const Context& context) {
  const auto compared = context.put_in_at_once(false), all = context.put_in_at_once(true);
  ex residual = 0;
  for (const Tree& side : equation.relation.sides) {
    const ex value = lower(side, context.symbols);
    if (has_no_value(put_in(value, all), context.symbols)) contradicts(equation.text);
    residual = value - residual;
  }
  if (sign_of(put_in(residual, compared), context.symbols) != 0) contradicts(equation.text);
}

bool is_always_zero(const ex& e, const Symbols& symbols) {
  try {
    return vanishes(e, symbols);
  } catch (const Undecidable&) {
    return false;
  }
}

void solve(const Assumed& equation, Context& context, const std::vector<std::string>& small) {
  Symbols& symbols = context.symbols;
  const auto value = [&](std::size_t side) {
    return put_in(reading(equation.text, [&] { return lower(equation.relation.sides[side], symbols); }),
                  context.put_in_at_once(true));
  };
  const Sides sides{value(0), "=", value(1)};
  const ex left = sides.left - sides.right;
  if (left.normal().is_zero()) return;  // it says nothing new
  if (is_always_zero(left, symbols)) return;
  if (sign_of(left, symbols) != 0) contradicts(equation.text);
  const auto given = solved(sides, equation, context, small);
  if (!given) refuse_equation(left, equation);
  context.given.push_back(*given);
}

/// In all symbols together: these say most simply what one is.
bool is_linear(const Assumed& equation, const Symbols& symbols) {
  const auto& sides = equation.relation.sides;
  const ex residual =
      reading(equation.text, [&] { return (lower(sides[0], symbols) - lower(sides[1], symbols)).expand(); });
  const auto names = names_in(residual);
  return std::all_of(names.begin(), names.end(), [&](const std::string& name) {
    return GiNaC::is_a<GiNaC::numeric>(residual.diff(GiNaC::ex_to<GiNaC::symbol>(symbols[name])));
  });
}

}  // namespace

void avoid_divisors(const Relation& relation, Symbols& symbols) {
  for (const Tree& side : relation.sides)
    for (const ex& divisor : divisors(side, symbols))
      if (sign_of(divisor, symbols) == 0) symbols.exclude_witnesses(divisor);
}

void keep_values(const std::string& text, const std::vector<Tree>& sides, const std::vector<ex>& kept,
                 const Context& context) {
  const Symbols& symbols = context.symbols;
  const auto all = context.put_in_at_once(true);
  std::vector<ex> needed;
  for (const ex& value : kept)
    for (const Condition& c : conditions_of(to_tree(value, symbols), symbols)) needed.push_back(c.value);
  for (const Tree& side : sides)
    for (const Condition& c : conditions_of(side, symbols, all)) {
      const ex value = put_in(c.value, all);
      if (c.relation == "!=" || value.is_zero()) continue;
      const auto says_it = [&](const ex& e) {
        return (e / value).normal().info(GiNaC::info_flags::positive);
      };
      if (std::none_of(needed.begin(), needed.end(), says_it))
        throw SeveralSolutions("the assumption '" + text + "' has a value for " + in_words(c, symbols) +
                                   " only, which what is left of it no longer says: assume that as well",
                               {in_words(c, symbols)});
    }
}

void read_equations(const std::vector<Assumed>& equations, Context& context,
                    const std::vector<std::string>& small) {
  Symbols& symbols = context.symbols;
  for (const Assumed& equation : equations)
    reading(equation.text, [&] { avoid_divisors(equation.relation, symbols); });
  std::vector<Assumed> others;
  for (const Assumed& equation : equations) {
    const auto& sides = equation.relation.sides;
    if (const auto given = read_given(sides[0], sides[1], equation.text, context, small))
      context.given.push_back(*given);
    else
      others.push_back(equation);
  }
  std::stable_partition(others.begin(), others.end(),
                        [&](const Assumed& e) { return is_linear(e, symbols); });
  for (const Assumed& other : others) solve(other, context, small);
  const auto all = context.put_in_at_once(true);
  for (const Given& given : all) check_range(given, all, symbols);
  for (const Assumed& equation : equations) check_equation(equation, context);
  std::vector<ex> values;
  for (const Given& given : all) values.push_back(given.value);
  for (const Assumed& equation : equations)
    keep_values(equation.text, equation.relation.sides, values, context);
}

}  // namespace rederive
