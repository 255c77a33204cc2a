#include <algorithm>
#include <array>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/decide_one.hpp>
#include <lessons/ledger/one_phase.hpp>
#include <numeric>

namespace rederive {

using GiNaC::ex;

namespace {

/// The expressions that are compared, or the differences of the sides of relations.
std::vector<ex> compared_in(const Relation& relation, const Context& context) {
  std::vector<ex> values;
  for (const Tree& side : relation.sides)
    values.push_back(
        with_exponents_together(put_in(lower(side, context.symbols), context.put_in_at_once(true))));
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

/// x*y of 3*x^2*y^2, and 1/x of -2/x^4: the product of symbols of which it is a number times a power; else 0.
ex product_in(const ex& e) {
  std::vector<std::pair<ex, int>> powers;
  int common = 0;
  for (const ex& f : GiNaC::is_a<GiNaC::mul>(e) ? e : ex(GiNaC::lst{e})) {
    if (GiNaC::is_a<GiNaC::numeric>(f)) continue;
    const bool is_power = GiNaC::is_a<GiNaC::power>(f) && f.op(1).info(GiNaC::info_flags::integer);
    const ex base = is_power ? f.op(0) : f, exponent = is_power ? f.op(1) : ex(1);
    if (!GiNaC::is_a<GiNaC::symbol>(base)) return 0;
    powers.emplace_back(base, GiNaC::ex_to<GiNaC::numeric>(exponent).to_int());
    common = std::gcd(common, powers.back().second);
  }
  ex product = powers.empty() ? 0 : 1;
  for (const auto& [base, n] : powers) product *= GiNaC::pow(base, n / common);
  return product;
}

bool is_reciprocal(const ex& phase) { return GiNaC::is_a<GiNaC::power>(phase) && phase.op(1).is_equal(-1); }

/// What stands in a function or below a power, and the product of which that is a power, if it has two
/// symbols and more, or is 1/x; in the order of their texts.
std::map<std::string, ex> candidates(const std::vector<ex>& values, const Symbols& symbols) {
  std::map<std::string, ex> result;
  for (const ex& value : values)
    for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part)
      if (GiNaC::is_a<GiNaC::function>(*part) || GiNaC::is_a<GiNaC::power>(*part))
        for (const ex& phase : {part->op(0), product_in(part->op(0))})
          if (names_in(phase).size() > 1 || is_reciprocal(phase))
            result.emplace(print(phase, Notation::plain, symbols), phase);
  return result;
}

/// How many symbols there are, and how many of them stand in functions, and how many of these below there.
std::array<std::size_t, 3> entanglement(const std::vector<ex>& values) {
  std::set<std::string> inside, below;
  for (const ex& value : values)
    for (auto part = value.preorder_begin(); part != value.preorder_end(); ++part)
      if (GiNaC::is_a<GiNaC::function>(*part)) {
        inside.merge(names_in(part->op(0)));
        below.merge(names_in(part->op(0).denom()));
      }
  return {names_in_all(values).size(), inside.size(), below.size()};
}

std::string end_of_range(const End& end, bool is_low) {
  const bool is_known = end.infinite == 0 && (end.value.info(GiNaC::info_flags::rational) ||
                                              (end.value / GiNaC::Pi).info(GiNaC::info_flags::rational));
  if (!is_known) return is_low ? "(-inf" : "inf)";
  const std::string value = print(end.value);
  return is_low ? (end.closed ? "[" : "(") + value : value + (end.closed ? "]" : ")");
}

/// What the symbol is if this is what the phase is; nothing where the phase is neither linear in it, nor in
/// the square of what has a sign, nor a multiple of 1 over it; or where it may be any number for one phase.
std::optional<ex> solved_for(const GiNaC::symbol& symbol, const ex& phase, const ex& in_its_place,
                             const Symbols& symbols) {
  const ex slope = phase.diff(symbol), above = (phase * symbol).normal();
  if (sign_of(slope, symbols) == 0) return std::nullopt;
  if (!above.has(symbol)) return above / in_its_place;
  if (phase.is_polynomial(symbol) && phase.degree(symbol) == 2 && phase.coeff(symbol, 1).is_zero() &&
      sign_of(symbol, symbols) != 0)
    return sign_of(symbol, symbols) *
           GiNaC::sqrt(((in_its_place - phase.coeff(symbol, 0)) / phase.coeff(symbol, 2)).expand());
  if (slope.has(symbol)) return std::nullopt;
  return ((in_its_place - phase.subs(symbol == 0)) / slope).expand();
}

/// A symbol of its own in the place of a phase; nothing where that cannot be solved for one in it, or nothing
/// is simpler then: all that it has stands somewhere else, too.
std::optional<Case> replaced(const ex& phase, const Interval& range, const std::vector<ex>& values,
                             const Case& one) {
  const Symbols& symbols = one.context.symbols;
  for (const std::string& name : names_in(phase)) {
    if (name.starts_with("excess_")) continue;
    Case result = one;
    auto& comparisons = result.context.comparisons;
    const std::string excess = "excess_" + std::to_string(comparisons.size() + 1);
    const std::string meaning = without_excess(print(phase, Notation::plain, symbols), comparisons, symbols);
    const std::string ends = end_of_range(range.low, true) + ", " + end_of_range(range.high, false);
    const ex in_its_place =
        result.context.symbols.declare(excess, excess, excess, "1", ends, meaning, "").ginac;
    const auto value = solved_for(symbols[name], phase, in_its_place, symbols);
    if (!value) continue;
    const Given solved{symbols[name], *value};
    std::vector<ex> after;
    for (const ex& v : values) after.push_back(with_exponents_together(put_in(v, {solved}).expand()));
    if (entanglement(after) >= entanglement(values)) continue;
    comparisons.push_back({solved, excess, meaning});
    return result;
  }
  return std::nullopt;
}

bool is_in_logarithm(const ex& phase, const std::vector<ex>& values) {
  return std::any_of(values.begin(), values.end(), [&](const ex& value) { return value.has(log(phase)); });
}

/// The range; or, if it goes on on both sides of this, what is not below it, and what is not above.
std::vector<std::pair<std::string, Interval>> apart_at(const ex& value, const Interval& range) {
  const bool is_above = range.low.infinite == 0 && compare(range.low.value, value) >= 0,
             is_below = range.high.infinite == 0 && compare(range.high.value, value) <= 0;
  if (is_above || is_below) return {{"", range}};
  const End end{value, 0, true};
  return {{" >= " + print(value), {end, range.high}}, {" <= " + print(value), {range.low, end}}};
}

}  // namespace

std::vector<Case> with_one_phase(const Case& one) {
  const auto& [request, context, in_pieces] = one;
  const Symbols& symbols = context.symbols;
  std::vector<ex> values = compared_in(read(request.left, symbols), context);
  for (const ex& value : compared_in(read(request.right, symbols), context)) values.push_back(value);
  for (const auto& [text, phase] : candidates(values, symbols)) {
    if (!conditions_of(to_tree(phase, symbols), symbols).empty()) continue;  // it has no value somewhere
    std::vector<Case> result;
    const ex turn = is_in_logarithm(phase, values) ? 1 : 0;  // where functions of it often change their sign
    for (const auto& [sign, range] : apart_at(turn, interval_of(phase, symbols))) {
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
