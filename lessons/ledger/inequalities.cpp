#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/print.hpp>
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

}  // namespace rederive
