#include <algorithm>
#include <cctype>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/witness.hpp>
#include <derivations/algebra/zeros.hpp>
#include <lessons/ledger/comparisons.hpp>

namespace rederive {

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;

namespace {

bool is_polynomial(const ex& e) {
  return std::all_of(e.preorder_begin(), e.preorder_end(), [](const ex& part) {
    const bool is_power = is_a<GiNaC::power>(part) && part.op(1).info(GiNaC::info_flags::posint);
    return is_power || is_a<GiNaC::add>(part) || is_a<GiNaC::mul>(part) || is_a<GiNaC::symbol>(part) ||
           part.info(GiNaC::info_flags::rational);
  });
}

std::vector<Given> givens(const std::vector<Comparison>& comparisons) {
  std::vector<Given> result;
  for (const Comparison& c : comparisons) result.push_back(c.given);
  return result;
}

/// Whether the symbol may be replaced by other + excess, or other - excess where it is the lesser.
bool is_replaceable(const ex& symbol, const ex& other, const std::vector<Comparison>& before) {
  if (!is_a<GiNaC::symbol>(symbol) || !is_polynomial(other)) return false;
  const bool is_replaced = std::any_of(before.begin(), before.end(),
                                       [&](const Comparison& c) { return c.given.name.is_equal(symbol); });
  return !is_replaced && !put_in(other, givens(before)).has(symbol);
}

/// Whether the range of the greater one follows from that of the lesser one.
bool has_room(const ex& greater, const ex& lesser, const Symbols& symbols) {
  const Interval range = parse_range(symbols.find(greater)->range);
  if (range.high.infinite == 0) return false;
  return range.low.infinite != 0 || is_nonnegative(lesser - range.low.value, symbols);
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

/// The difference that an inequality says to be positive.
ex difference(const Relation& inequality, const Symbols& symbols) {
  const ex left = lower(inequality.sides[0], symbols), right = lower(inequality.sides[1], symbols);
  return inequality.operators[0][0] == '<' ? right - left : left - right;
}

/// Of other + excess, where only bounds of the excess are known: so of the sum, or the difference.
void move_bounds(Witness& witness, const Comparison& c, const std::vector<Comparison>& all,
                 const Symbols& symbols) {
  const auto bounds = witness.between.find(c.excess);
  if (bounds == witness.between.end()) return;
  const auto value = [&](const cln::cl_RA& excess) {
    Point point{{c.excess, excess}};
    for (const auto& [name, number] : witness.at)
      if (name != c.excess) point[name] = cln::cl_RA(number.c_str());
    return put_in(c.given.value, givens(all)).subs(values_at(point, symbols));
  };
  const auto rational = [](const ex& e) { return cln::the<cln::cl_RA>(ex_to<GiNaC::numeric>(e).to_cl_N()); };
  const ex a = value(bounds->second.low), b = value(bounds->second.high);
  const std::string name = symbols.find(c.given.name)->name;
  witness.between[name] = {cln::min(rational(a), rational(b)), cln::max(rational(a), rational(b))};
  witness.exactly.erase(name);
}

/// An expression, or an equation "… = 0", in the symbols that the user knows.
std::string without_excess(std::string text, const std::vector<Comparison>& comparisons,
                           const Symbols& symbols) {
  const std::string before = text;
  for (const Comparison& c : comparisons) replace_all(text, c.excess, "(" + c.meaning + ")");
  if (text == before) return text;
  const Relation relation = parse_statement(text, symbols);
  return print(lower(relation.sides[0], symbols), Notation::plain, symbols) +
         (relation.operators.empty() ? "" : " = 0");
}

/// Says the witness in the symbols that the user knows.
void forget_excess(Witness& witness, const std::vector<Comparison>& comparisons, const Symbols& symbols) {
  for (const Comparison& c : comparisons) move_bounds(witness, c, comparisons, symbols);
  for (const Comparison& c : comparisons)
    witness.at.erase(c.excess), witness.exactly.erase(c.excess), witness.between.erase(c.excess);
  witness.solves = without_excess(witness.solves, comparisons, symbols);
  for (auto& [name, text] : witness.exactly) text = without_excess(text, comparisons, symbols);
}

}  // namespace

int settled_by(const std::vector<Comparison>& before, const Relation& inequality, const Symbols& symbols) {
  const ex excess = put_in(difference(inequality, symbols), givens(before)).expand();
  const bool weak = inequality.operators[0].size() == 2;
  if (weak ? is_nonnegative(excess, symbols) : sign_of(excess, symbols) > 0) return 1;
  return (weak ? sign_of(excess, symbols) < 0 : is_nonnegative(-excess, symbols)) ? -1 : 0;
}

std::optional<Comparison> compared(const Relation& inequality, const std::vector<Comparison>& before,
                                   Symbols& symbols) {
  const bool rises = inequality.operators[0][0] == '<', weak = inequality.operators[0].size() == 2;
  const ex greater = lower(inequality.sides[rises ? 1 : 0], symbols),
           lesser = lower(inequality.sides[rises ? 0 : 1], symbols);
  const bool up = is_replaceable(greater, lesser, before), down = is_replaceable(lesser, greater, before);
  if (!up && !down) return std::nullopt;
  const std::string name = "excess_" + std::to_string(before.size() + 1);
  const std::string meaning = print(greater - lesser, Notation::plain, symbols);
  const bool is_up =
      up && (!down || has_room(greater, lesser, symbols) || symbols.find(lesser)->range != "(-inf, inf)");
  const std::string unit = symbols.find(is_up ? greater : lesser)->unit;
  const std::string range = (weak ? "[0, " : "(0, ") + upper_end(greater - lesser, symbols);
  const ex excess = symbols.declare(name, name, name, unit, range, meaning, "").ginac;
  return Comparison{is_up ? Given{greater, lesser + excess} : Given{lesser, greater - excess}, name, meaning};
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
