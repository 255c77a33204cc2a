#include <algorithm>
#include <cctype>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/comparisons.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

namespace {

std::vector<Given> givens(const std::vector<Comparison>& comparisons) {
  std::vector<Given> result;
  for (const Comparison& c : comparisons) result.push_back(c.given);
  return result;
}

/// Whether the declared range of the symbol says no more than that it lies beyond the bound.
bool is_whole_range(const Bound& bound, const Symbols& symbols) {
  const Interval range = parse_range(symbols.find(bound.symbol)->range);
  const End &open = bound.is_lower ? range.high : range.low, &other = bound.is_lower ? range.low : range.high;
  if (open.infinite == 0) return false;
  const ex inside = bound.is_lower ? bound.value - other.value : other.value - bound.value;
  return other.infinite != 0 || is_nonnegative(inside, symbols);
}

bool is_excess(const std::string& name) { return name.starts_with("excess_"); }

/// How well a bound does for what is replaced: without loss; as the user wrote it; the greater one.
int rank(const Bound& bound, const Inequality& inequality, const Symbols& symbols) {
  const bool is_alone = bound.symbol.is_equal(inequality.greater) || bound.symbol.is_equal(inequality.lesser);
  return 4 * is_whole_range(bound, symbols) + 2 * is_alone + bound.is_lower;
}

/// For the symbol that does best; nothing that stands for an excess.
std::optional<Bound> solved(const Inequality& inequality, const ex& difference, const Symbols& symbols) {
  std::optional<Bound> best;
  for (const std::string& name : names_in(difference)) {
    if (is_excess(name)) continue;
    const auto bound = solved_for(symbols[name], difference, symbols);
    if (bound && (!best || rank(*bound, inequality, symbols) > rank(*best, inequality, symbols)))
      best = bound;
  }
  return best;
}

/// Up to what the declared ranges let a positive difference grow, for a range: "pi/2)"; "inf)" if that is not
/// known, or nothing that a range can say.
std::string upper_end(const ex& difference, const Symbols& symbols) {
  const End end = interval_of(difference, symbols).high;
  const bool is_known = end.infinite == 0 && (end.value.info(GiNaC::info_flags::rational) ||
                                              (end.value / GiNaC::Pi).info(GiNaC::info_flags::rational));
  return is_known ? print(end.value, Notation::plain, symbols) + (end.closed ? "]" : ")") : "inf)";
}

/// Of a name, where it stands whole: excess_1 is not in excess_10.
void replace_all(std::string& text, const std::string& name, const std::string& by) {
  for (std::size_t at = text.find(name); at != std::string::npos;) {
    const std::size_t end = at + name.size();
    const bool goes_on = end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0;
    if (!goes_on) text.replace(at, name.size(), by);
    at = text.find(name, goes_on ? end : at + by.size());
  }
}

/// The value itself, where that is rational; else one to 45 places on that side of it.
cln::cl_RA rational_near(const Tree& value, const Point& point, int side, const Symbols& symbols) {
  const ex exact = lower(value, symbols).subs(values_at(point, symbols), GiNaC::subs_options::no_pattern);
  if (exact.info(GiNaC::info_flags::rational))
    return cln::the<cln::cl_RA>(ex_to<GiNaC::numeric>(exact).to_cl_N());
  const cln::cl_RA places = cln::cl_RA(power_of_ten(45));
  return (cln::round1(evaluate(value, point, 60).value() * places) + side) / places;
}

/// Of other + excess, where only bounds of the excess are known: so of the sum, or the difference.
void move_bounds(Witness& witness, const Comparison& c, const std::vector<Comparison>& all,
                 const Symbols& symbols) {
  const auto bounds = witness.between.find(c.excess);
  if (bounds == witness.between.end()) return;
  const Tree value = to_tree(put_in(c.given.value, givens(all)), symbols);
  const auto at = [&](const cln::cl_RA& excess, int side) {
    Point point{{c.excess, excess}};
    for (const auto& [name, number] : witness.at)
      if (name != c.excess) point[name] = cln::cl_RA(number.c_str());
    return rational_near(value, point, side, symbols);
  };
  const std::string name = symbols.find(c.given.name)->name;
  const cln::cl_RA &low = bounds->second.low, &high = bounds->second.high;
  witness.between[name] = {cln::min(at(low, -1), at(high, -1)), cln::max(at(low, 1), at(high, 1))};
  witness.exactly.erase(name);
}

/// The excess by the symbol that has its bounds from now on, so that no other one is said by way of itself.
void say_by_symbol(Witness& witness, const Comparison& c, const std::vector<Comparison>& all,
                   const Symbols& symbols) {
  if (!witness.between.contains(c.excess)) return;
  GiNaC::exmap values;
  for (const auto& [name, number] : witness.at) {
    const auto exactly = witness.exactly.find(name);
    if (name != c.excess)
      values[symbols[name]] = exactly != witness.exactly.end()
                                  ? lower(parse(exactly->second, symbols), symbols)
                                  : ex(GiNaC::numeric(number.c_str()));
  }
  const ex excess = symbols[c.excess];
  const ex value = put_in(c.given.value, givens(all)).subs(values, GiNaC::subs_options::no_pattern).expand();
  if (!value.is_polynomial(excess) || value.degree(excess) != 1) return;
  const ex by_symbol = (c.given.name - value.coeff(excess, 0)) / value.coeff(excess, 1);
  for (auto& [name, text] : witness.exactly)
    if (text.find(c.excess) != std::string::npos)
      text = print(lower(parse(text, symbols), symbols).subs(excess == by_symbol).expand(), Notation::plain,
                   symbols);
}

/// Says the witness in the symbols that the user knows.
void forget_excess(Witness& witness, const std::vector<Comparison>& comparisons, const Symbols& symbols) {
  for (const Comparison& c : comparisons) say_by_symbol(witness, c, comparisons, symbols);
  for (const Comparison& c : comparisons) move_bounds(witness, c, comparisons, symbols);
  for (const Comparison& c : comparisons)
    witness.at.erase(c.excess), witness.exactly.erase(c.excess), witness.between.erase(c.excess);
  witness.solves = without_excess(witness.solves, comparisons, symbols);
  for (auto& [name, text] : witness.exactly) text = without_excess(text, comparisons, symbols);
}

}  // namespace

std::string without_excess(std::string text, const std::vector<Comparison>& comparisons,
                           const Symbols& symbols) {
  const std::string before = text;
  for (const Comparison& c : comparisons) replace_all(text, c.excess, "(" + c.meaning + ")");
  if (text == before) return text;
  const Relation relation = parse_statement(text, symbols);
  return print(lower(relation.sides[0], symbols), Notation::plain, symbols) +
         (relation.operators.empty() ? "" : " = 0");
}

int settled_by(const std::vector<Comparison>& before, const Inequality& inequality, const Symbols& symbols) {
  const ex excess = put_in(inequality.difference(), givens(before)).normal().expand();
  const bool weak = inequality.weak;
  if (weak ? is_nonnegative(excess, symbols) : sign_of(excess, symbols) > 0) return 1;
  return (weak ? sign_of(excess, symbols) < 0 : is_nonnegative(-excess, symbols)) ? -1 : 0;
}

std::optional<Comparison> compared(const Inequality& inequality, const std::vector<Comparison>& before,
                                   Symbols& symbols) {
  const auto bound = solved(inequality, put_in(inequality.difference(), givens(before)), symbols);
  if (!bound) return std::nullopt;
  // of t < pi/w the excess is pi - w*t: that is the room which a phase w*t has
  const ex fraction = bound->value.numer_denom(), by = sign_of(fraction.op(1), symbols) * fraction.op(1);
  const ex over = by.is_zero() ? ex(1) : by;
  const ex room =
      (over * (bound->is_lower ? bound->symbol - bound->value : bound->value - bound->symbol)).normal();
  const std::string name = "excess_" + std::to_string(before.size() + 1);
  const std::string meaning = without_excess(print(room, Notation::plain, symbols), before, symbols);
  const std::string range = (inequality.weak ? "[0, " : "(0, ") + upper_end(room, symbols);
  const std::string unit = symbols.find(bound->symbol)->unit;
  const ex excess = symbols.declare(name, name, name, unit, range, meaning, "").ginac;
  const ex value = bound->is_lower ? bound->value + excess / over : bound->value - excess / over;
  return Comparison{Given{bound->symbol, value}, name, meaning};
}

Proof without_excess(Proof proof, const std::vector<Comparison>& comparisons, const Symbols& symbols) {
  for (const Comparison& c : comparisons) {
    for (std::string* text : {&proof.factor, &proof.reason})
      replace_all(*text, c.excess, "(" + c.meaning + ")");
    for (std::string& text : proof.side_conditions) replace_all(text, c.excess, "(" + c.meaning + ")");
  }
  if (!proof.factor.empty() && !comparisons.empty())
    proof.factor = print(lower(parse(proof.factor, symbols), symbols), Notation::plain, symbols);
  if (proof.witness) forget_excess(*proof.witness, comparisons, symbols);
  return proof;
}

}  // namespace rederive
