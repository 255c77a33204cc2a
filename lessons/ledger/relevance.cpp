#include <algorithm>
#include <derivations/algebra/conjunction.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/roots.hpp>
#include <derivations/algebra/vanish.hpp>
#include <lessons/ledger/relevance.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

namespace {

/// Whether it has a value at all points of the declared ranges: no root, divisor or function in it may fail.
bool has_value_everywhere(const ex& e, const Symbols& symbols) {
  for (const ex& part : e)
    if (!has_value_everywhere(part, symbols)) return false;
  if (is_a<GiNaC::power>(e))
    return e.op(1).info(GiNaC::info_flags::nonnegint) || sign_of(e.op(0), symbols) > 0 ||
           (e.op(1).info(GiNaC::info_flags::integer) && sign_of(e.op(0), symbols) != 0);
  if (!is_a<GiNaC::function>(e)) return true;
  const std::string name = name_of(e);
  return name == "sin" || name == "cos" || name == "exp" || name == "sinh" || name == "cosh" ||
         name == "tanh" || name == "atan" || name == "asinh" || name == "abs";
}

/// Whether the value lies in the range of its name, whatever the symbols are.
bool is_always_in_range(const Given& given, const std::vector<Given>& all, const Symbols& symbols) {
  const Symbol* name = symbols.find(given.name);
  const ex value = put_in(given.value, all);
  if (name == nullptr) return has_value_everywhere(value, symbols);
  const auto keeps = [&](const End& end, int side) {
    if (end.infinite != 0) return true;
    const ex inside = side * (value - end.value);
    return end.closed ? is_nonnegative(inside, symbols) : sign_of(inside, symbols) > 0;
  };
  const Interval range = parse_range(name->range);
  return has_value_everywhere(value, symbols) && keeps(range.low, 1) && keeps(range.high, -1);
}

/// Whether a root of the right one, at which the left one is not 0, shows at once that two equations differ.
bool differ_at_first_sight(const Residuals& r, const Symbols& symbols) {
  const auto is_far = [&](const Root& root) {
    const auto left = value_of(r.pair.left, root.at);
    return left && !is_nearly_zero(*left) && is_admitted(r.pair, root.at, symbols);
  };
  return find_root({r.pair.right, r.pair.right_value}, points_for(r.pair, symbols), 1, Roots::crossings,
                   symbols, is_far)
      .has_value();
}

/// Of one equation and another.
bool are_equations_by_factor(const Question& question) {
  const Residuals r = residuals_of(links_of(question.left)[0], links_of(question.right)[0], question);
  return !differ_at_first_sight(r, question.symbols) && differ_by_some_factor(r, question.symbols);
}

}  // namespace

std::vector<Given> relevant(const std::vector<Given>& given, const Relation& left, const Relation& right,
                            const Symbols& symbols) {
  std::set<std::string> names;
  const auto mention = [&](const ex& e) {
    for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
      if (is_a<GiNaC::symbol>(*part)) names.insert(ex_to<GiNaC::symbol>(*part).get_name());
  };
  for (const Relation* relation : {&left, &right})
    for (const Tree& side : relation->sides) collect_names(side, names);
  for (const auto* list : {&symbols.never_zero(), &symbols.no_witness()})
    for (const ex& e : *list) mention(e);
  for (std::size_t before = names.size() + 1; before != names.size();) {
    before = names.size();
    for (const Given& g : given)
      if (names.contains(ex_to<GiNaC::symbol>(g.name).get_name()) || !is_always_in_range(g, given, symbols))
        mention(g.name), mention(g.value);
  }
  std::vector<Given> result = given;
  std::erase_if(result,
                [&](const Given& g) { return !names.contains(ex_to<GiNaC::symbol>(g.name).get_name()); });
  return result;
}

bool goes_through(const Relation& left, const Relation& right, const Symbols& symbols,
                  const std::vector<Given>& given) {
  try {
    const Symbols with_ranges = with_ranges_of(given, symbols);
    const Question question{left, right, with_ranges, given};
    if (left.operators.empty() != right.operators.empty()) return false;
    if (left.operators.empty())
      return vanishes(put_in(lower(left.sides[0], symbols) - lower(right.sides[0], symbols), given), symbols);
    const bool are_equations =
        left.operators == right.operators && left.operators == std::vector<std::string>{"="};
    return are_equations ? are_equations_by_factor(question) : match_at_once(question);
  } catch (const std::exception&) {  // outside the class, or a pole of GiNaC
    return false;
  }
}

}  // namespace rederive
