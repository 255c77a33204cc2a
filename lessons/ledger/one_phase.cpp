#include <algorithm>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <lessons/ledger/decide_one.hpp>
#include <lessons/ledger/one_phase.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// The expressions that are compared, or the differences of the sides of relations.
std::vector<ex> compared_in(const Relation& relation, const Context& context) {
  std::vector<ex> values;
  for (const Tree& side : relation.sides)
    values.push_back(put_in(lower(side, context.symbols), context.put_in_at_once(true)));
  if (relation.operators.empty()) return values;
  for (std::size_t k = 0; k + 1 < values.size(); ++k) values[k] -= values[k + 1];
  values.pop_back();
  return values;
}

std::set<std::string> names_in_all(const std::vector<ex>& values) {
  std::set<std::string> names;
  for (const ex& value : values)
    for (const std::string& name : names_in(value)) names.insert(name);
  return names;
}

/// What has two symbols and more, and stands in a function or below a power; in the order of their texts.
std::map<std::string, ex> candidates(const std::vector<ex>& values, const Symbols& symbols) {
  std::map<std::string, ex> result;
  for (const ex& value : values)
    for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part)
      if (GiNaC::is_a<GiNaC::function>(*part) || GiNaC::is_a<GiNaC::power>(*part))
        if (const ex inside = part->op(0); names_in(inside).size() > 1)
          result.emplace(print(inside, Notation::plain, symbols), inside);
  return result;
}

std::string end_of_range(const End& end, bool is_low) {
  const bool is_known = end.infinite == 0 && (end.value.info(GiNaC::info_flags::rational) ||
                                              (end.value / GiNaC::Pi).info(GiNaC::info_flags::rational));
  if (!is_known) return is_low ? "(-inf" : "inf)";
  const std::string value = print(end.value);
  return is_low ? (end.closed ? "[" : "(") + value : value + (end.closed ? "]" : ")");
}

/// A symbol of its own in the place of what has several; nothing where it is linear in none of them, or where
/// all that it has stands somewhere else, too.
std::optional<Case> replaced(const ex& phase, const Interval& range, const std::vector<ex>& values,
                             const Case& one) {
  const Symbols& symbols = one.context.symbols;
  for (const std::string& name : names_in(phase)) {
    const ex& symbol = symbols[name];
    const ex slope = phase.diff(symbols[name]);
    if (name.starts_with("excess_") || slope.has(symbol) || sign_of(slope, symbols) == 0) continue;
    Case result = one;
    auto& comparisons = result.context.comparisons;
    const std::string excess = "excess_" + std::to_string(comparisons.size() + 1);
    const std::string meaning = without_excess(print(phase, Notation::plain, symbols), comparisons, symbols);
    const std::string ends = end_of_range(range.low, true) + ", " + end_of_range(range.high, false);
    const ex in_its_place =
        result.context.symbols.declare(excess, excess, excess, "1", ends, meaning, "").ginac;
    const Given solved{symbols[name], ((in_its_place - phase.subs(symbol == 0)) / slope).expand()};
    std::vector<ex> after;
    for (const ex& value : values) after.push_back(put_in(value, {solved}).expand());
    if (names_in_all(after).size() >= names_in_all(values).size()) continue;
    comparisons.push_back({solved, excess, meaning});
    return result;
  }
  return std::nullopt;
}

/// The range; or what is not negative of it, and what is not positive, where it has both.
std::vector<std::pair<std::string, Interval>> of_one_sign(const Interval& range) {
  const bool is_above = range.low.infinite == 0 && compare(range.low.value, 0) >= 0,
             is_below = range.high.infinite == 0 && compare(range.high.value, 0) <= 0;
  if (is_above || is_below) return {{"", range}};
  const End zero{0, 0, true};
  return {{" >= 0", {zero, range.high}}, {" <= 0", {range.low, zero}}};
}

}  // namespace

std::vector<Case> with_one_phase(const Case& one) {
  const auto& [request, context, in_pieces] = one;
  const Symbols& symbols = context.symbols;
  std::vector<ex> values = compared_in(read(request.left, symbols), context);
  for (const ex& value : compared_in(read(request.right, symbols), context)) values.push_back(value);
  for (const auto& [text, phase] : candidates(values, symbols)) {
    std::vector<Case> result;
    for (const auto& [sign, range] : of_one_sign(interval_of(phase, symbols))) {
      auto part = replaced(phase, range, values, one);
      if (!part) break;
      if (!sign.empty()) part->request.assumptions.push_back(part->context.comparisons.back().meaning + sign);
      result.push_back(std::move(*part));
    }
    if (!result.empty()) return result;
  }
  return {};
}

}  // namespace rederive
