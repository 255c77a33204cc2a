#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/solutions.hpp>
#include <derivations/algebra/vanish.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/assumed.hpp>
#include <lessons/ledger/solved_equations.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

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
  const bool turn = is_name(a) && is_name(b) &&
                    (is_small(a) || (symbols.find(b->text)->range == all_numbers && !is_small(b)));
  for (const auto& [name, value] : {turn ? std::pair{b, a} : std::pair{a, b}, std::pair{b, a}}) {
    if (!is_name(name)) continue;
    const Given given = reading(text, [&] { return Given{lower(name, symbols), lower(value, symbols)}; });
    if (given.value.has(given.name)) continue;
    const bool is_new = put_in(given.name, before).is_equal(given.name);
    if (is_new && !put_in(given.value, before).has(given.name)) return given;
  }
  return {};
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
  std::vector<Condition> needed;
  for (const ex& value : kept)
    for (const Condition& c : conditions_of(to_tree(value, symbols), symbols))
      needed.push_back({put_in(c.value, all), c.relation});
  for (const Tree& side : sides)
    for (const Condition& c : conditions_of(side, symbols, all)) {
      const ex value = put_in(c.value, all);
      if (c.relation == "!=" || value.is_zero()) continue;
      const auto says_it = [&](const Condition& other) {
        return (other.relation == ">" || other.relation == c.relation) &&
               (other.value / value).normal().info(GiNaC::info_flags::positive);
      };
      if (std::any_of(needed.begin(), needed.end(), says_it)) continue;
      const std::string message = "the assumption '" + text + "' has a value for " + in_words(c, symbols) +
                                  " only, which what is left of it no longer says: assume that as well";
      if (has_symbol_in_exponent(side, symbols)) throw BadInput(message);
      throw SeveralSolutions(message, {in_words(c, symbols)});
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
  for (const ex& e : symbols.never_zero())
    if (is_always_zero(put_in(e, all), symbols)) contradicts(print(e, Notation::plain, symbols) + " != 0");
  std::vector<ex> values;
  for (const Given& given : all) values.push_back(given.value);
  for (const Assumed& equation : equations)
    keep_values(equation.text, equation.relation.sides, values, context);
}

}  // namespace rederive
