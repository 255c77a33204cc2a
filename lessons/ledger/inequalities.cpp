#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/solutions.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/inequalities.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// Its numerator, turned such that it has the sign of the whole; nothing where the sign of what divides is
/// not known.
std::optional<ex> numerator(const ex& difference, const Symbols& symbols) {
  const ex fraction = difference.normal().numer_denom();
  const int side = sign_of(fraction.op(1), symbols);
  if (side == 0) return std::nullopt;
  return (side * fraction.op(0)).expand();
}

/// What stands between bars, if anything of unknown sign does.
std::optional<ex> first_with_bars(const ex& e) {
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
    if (name_of(*part) == "abs") return *part;
  return std::nullopt;
}

/// u < c and -c < u, or what is left of u < -c or c < u where the sign of u is known.
std::optional<std::vector<Inequality>> in_two(const ex& u, const Bound& bound, bool weak,
                                              const Symbols& symbols) {
  const ex& c = bound.value;
  if (!bound.is_lower) return std::vector<Inequality>{{c, u, weak}, {u, -c, weak}};
  if (is_nonnegative(u, symbols)) return std::vector<Inequality>{{u, c, weak}};
  if (is_nonnegative(-u, symbols)) return std::vector<Inequality>{{-u, c, weak}};
  return std::nullopt;
}

std::optional<std::vector<Inequality>> split(const Inequality& i, const Symbols& symbols) {
  const ex difference = i.difference();
  const GiNaC::realsymbol size("size");
  if (const auto bars = first_with_bars(difference)) {
    const ex in_size = difference.subs(*bars == size, GiNaC::subs_options::no_pattern);
    const auto bound = solved_for(size, in_size, symbols);
    if (bound) return in_two(bars->op(0), *bound, i.weak, symbols);
  }
  const auto names = names_in(difference);
  if (names.size() != 1) return std::nullopt;
  const ex symbol = symbols[*names.begin()];
  const ex square = numerator(difference, symbols).value_or(0);
  if (!square.is_polynomial(symbol) || square.degree(symbol) != 2 || !square.coeff(symbol, 1).is_zero())
    return std::nullopt;
  const auto bound = solved_for(size, square.coeff(symbol, 2) * size + square.coeff(symbol, 0), symbols);
  if (!bound || !is_nonnegative(bound->value, symbols)) return std::nullopt;
  return in_two(symbol, {size, GiNaC::sqrt(bound->value), bound->is_lower}, i.weak, symbols);
}

}  // namespace

Inequality inequality(const Relation& link, const Symbols& symbols) {
  const ex left = lower(link.sides[0], symbols), right = lower(link.sides[1], symbols);
  const bool rises = link.operators[0][0] == '<', weak = link.operators[0].size() == 2;
  return rises ? Inequality{right, left, weak} : Inequality{left, right, weak};
}

std::optional<Bound> solved_for(const ex& symbol, const ex& difference, const Symbols& symbols) {
  for (const auto& form : {std::optional(difference.expand()), numerator(difference, symbols)}) {
    if (!form || !form->is_polynomial(symbol) || form->degree(symbol) != 1) continue;
    const ex slope = form->coeff(symbol, 1), rest = form->coeff(symbol, 0);
    const int rise = sign_of(slope, symbols);
    if (rise != 0) return Bound{symbol, (-rest / slope).normal(), rise > 0};
  }
  return std::nullopt;
}

std::vector<Inequality> without_bars(const Inequality& inequality, const Symbols& symbols) {
  const auto parts = split(inequality, symbols);
  if (!parts) return {inequality};
  std::vector<Inequality> result;
  for (const Inequality& part : *parts)
    for (const Inequality& one : without_bars(part, symbols)) result.push_back(one);
  return result;
}

namespace {

/// An open piece of the range of a symbol, or what is added of its ends.
std::string as_text(const std::string& name, const Interval& piece, const Symbols& symbols) {
  const auto number = [&](const End& end) { return print(end.value, Notation::plain, symbols); };
  const End &low = piece.low, &high = piece.high;
  if (low.infinite == 0 && high.infinite == 0)
    return number(low) + (low.closed ? " <= " : " < ") + name + (high.closed ? " <= " : " < ") + number(high);
  if (low.infinite == 0) return name + (low.closed ? " >= " : " > ") + number(low);
  return name + (high.closed ? " <= " : " < ") + number(high);
}

ex inside(const Interval& piece) {
  if (piece.low.infinite != 0) return piece.high.infinite != 0 ? ex(0) : piece.high.value - 1;
  return piece.high.infinite != 0 ? piece.low.value + 1 : (piece.low.value + piece.high.value) / 2;
}

/// An inequality of one symbol: where it can change, and whether it holds at a place. Between its zeros and
/// those of all that it needs to have a value, as x in atan(2/x), it keeps its sign.
class OfOne {
 public:
  OfOne(const Inequality& i, ex symbol, const Symbols& symbols)
      : difference_(with_open_tangents(i.difference())), symbol_(std::move(symbol)), weak_(i.weak) {
    zeros_ = known_zeros(difference_.normal().numer(), symbols);
    for (const Condition& c : conditions_of(to_tree(difference_, symbols), symbols))
      if (c.value.has(symbol_)) needed_.emplace_back(c, known_zeros(c.value, symbols));
  }

  std::vector<ex> cuts() const {
    std::vector<ex> all = zeros_;
    for (const auto& [condition, zeros] : needed_) all.insert(all.end(), zeros.begin(), zeros.end());
    std::sort(all.begin(), all.end(), [](const ex& a, const ex& b) { return compare(a, b) < 0; });
    return all;
  }

  bool holds_at(const ex& place) const {
    for (const auto& [condition, zeros] : needed_) {
      const int sign = sign_at(place, condition.value, zeros);
      if (condition.relation == "!=" ? sign == 0 : condition.relation == ">" ? sign <= 0 : sign < 0)
        return false;
    }
    const int sign = sign_at(place, difference_, zeros_);
    return sign > 0 || (sign == 0 && weak_);
  }

 private:
  static std::vector<ex> known_zeros(const ex& e, const Symbols& symbols) {
    const ex above = e.normal().numer();
    if (!has_symbol(above)) return {};  // 1/x has none
    if (const auto zeros = solutions(above, symbols)) return *zeros;
    throw Undecidable("its zeros are not known");
  }
  int sign_at(const ex& place, const ex& e, const std::vector<ex>& zeros) const {
    for (const ex& zero : zeros)
      if (compare(zero, place) == 0) return 0;
    return compare(e.subs(symbol_ == place), 0);
  }

  ex difference_, symbol_;
  bool weak_;
  std::vector<ex> zeros_;
  std::vector<std::pair<Condition, std::vector<ex>>> needed_;
};

/// Throws std::exception where zeros are not known, and constants that are too close to tell.
std::optional<std::vector<std::string>> pieces_of_one(const Inequality& i, const std::string& name,
                                                      const Symbols& symbols) {
  const OfOne inequality(i, symbols[name], symbols);
  const std::vector<ex> cuts = inequality.cuts();
  const Interval range = parse_range(symbols.find(name)->range);
  std::vector<std::string> result;
  End low = range.low;
  bool is_alone = false;  // a point without a piece beside it
  for (std::size_t k = 0; k <= cuts.size(); ++k) {
    End high = range.high;
    if (k < cuts.size()) high.infinite = 0, high.value = cuts[k], high.closed = inequality.holds_at(cuts[k]);
    const bool is_empty = low.infinite == 0 && high.infinite == 0 && compare(low.value, high.value) >= 0;
    const bool holds = !is_empty && inequality.holds_at(inside({low, high}));
    if (holds) result.push_back(cuts.empty() ? "" : as_text(name, {low, high}, symbols));
    if (!holds && is_alone) return std::nullopt;
    is_alone = !holds && high.closed && k < cuts.size();
    low = high;
  }
  return is_alone ? std::nullopt : std::optional(result);
}

/// The sign of a symbol that a product needs to be solved for another one.
std::optional<std::vector<std::string>> signs_of_one(const Inequality& i, const Symbols& symbols) {
  const ex difference = i.difference().expand();
  for (const std::string& name : names_in(difference)) {
    const ex& symbol = symbols[name];
    if (i.weak || !difference.is_polynomial(symbol) || difference.degree(symbol) != 1) continue;
    const ex slope = difference.coeff(symbol, 1), rest = difference.coeff(symbol, 0);
    const auto names = names_in(slope);
    if (names.size() != 1 || names.begin()->starts_with("excess_") || !is_nonnegative(-rest, symbols))
      continue;
    const ex& other = symbols[*names.begin()];
    if (GiNaC::is_a<GiNaC::numeric>(slope / other) || GiNaC::is_a<GiNaC::numeric>((slope * other).normal()))
      return {{*names.begin() + " > 0", *names.begin() + " < 0"}};
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::vector<std::string>> pieces(const Inequality& inequality, const Symbols& symbols) {
  const auto names = names_in(inequality.difference());
  if (names.size() != 1) return signs_of_one(inequality, symbols);
  if (names.begin()->starts_with("excess_")) return std::nullopt;
  try {
    return pieces_of_one(inequality, *names.begin(), symbols);
  } catch (const std::exception&) {  // constants that are too close to tell, or poles of GiNaC
    return std::nullopt;
  }
}

}  // namespace rederive
