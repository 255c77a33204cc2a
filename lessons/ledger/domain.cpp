#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/residuals.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/ledger/domain.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

bool never_holds(const Condition& condition, const std::vector<Given>& given, const Symbols& symbols) {
  return condition.relation != "!=" && settled(put_in(condition.value, given), claim_of(condition.relation),
                                               symbols) == std::optional(false);
}

/// Whether its logarithm is written somewhere: then it is positive wherever all has a value.
bool is_in_logarithm(const ex& base, const std::vector<ex>& sides) {
  return std::any_of(sides.begin(), sides.end(), [&](const ex& side) { return side.has(log(base)); });
}

/// Bases that may be negative, with an exponent that is no number.
std::vector<ex> doubtful_bases(const std::vector<ex>& sides, const Symbols& symbols) {
  std::vector<ex> bases;
  for (const ex& side : sides)
    for (auto part = side.preorder_begin(); part != side.preorder_end(); ++part)
      if (GiNaC::is_a<GiNaC::power>(*part) && has_symbol(part->op(1)) &&
          !is_nonnegative(part->op(0), symbols))
        bases.push_back(part->op(0));
  return bases;
}

bool has_any(const ex& e, const std::vector<ex>& symbols) {
  return std::any_of(symbols.begin(), symbols.end(), [&](const ex& symbol) { return e.has(symbol); });
}

/// Whether an expression is analytic in symbols of which it has powers with exponents that are no numbers, as
/// long as these are whole. Roots, bars and inverse functions of them are not.
bool is_analytic_in(const std::vector<ex>& bases, const ex& e) {
  static const std::set<std::string> analytic{"sin", "cos", "tan", "exp", "sinh", "cosh", "tanh"};
  return std::all_of(e.preorder_begin(), e.preorder_end(), [&](const ex& part) {
    if (!has_any(part, bases)) return true;
    if (GiNaC::is_a<GiNaC::function>(part)) return analytic.contains(name_of(part));
    if (!GiNaC::is_a<GiNaC::power>(part) || part.op(1).info(GiNaC::info_flags::integer)) return true;
    return has_symbol(part.op(1)) && GiNaC::is_a<GiNaC::symbol>(part.op(0)) && !has_any(part.op(1), bases);
  });
}

/// What is proved of expressions is proved where such a base is positive. Where it is negative the powers
/// have values for whole exponents alone; these are fixed, and what agrees for all positive numbers in its
/// place agrees for the negative ones, too, if it is analytic there.
bool agrees_for_negative(const std::vector<ex>& bases, const std::vector<ex>& sides) {
  const auto is_symbol = [](const ex& base) { return GiNaC::is_a<GiNaC::symbol>(base); };
  return std::all_of(bases.begin(), bases.end(), is_symbol) &&
         std::all_of(sides.begin(), sides.end(), [&](const ex& side) { return is_analytic_in(bases, side); });
}

}  // namespace

Proof with_domain(Proof proof, const Relation& left, const Relation& right, const std::vector<Given>& given,
                  const Symbols& symbols) {
  if (proof.verdict == Verdict::refuted || proof.verdict == Verdict::undecided) return proof;
  for (const Relation* relation : {&left, &right})
    for (const Tree& side : relation->sides)
      for (const Condition& condition : conditions_of(side, symbols, given))
        if (never_holds(condition, given, symbols))
          return undecided("it needs " + in_words(condition, symbols) +
                           ", which holds nowhere in the declared ranges");
  std::vector<ex> sides;
  for (const Relation* relation : {&left, &right})
    for (const Tree& side : relation->sides) sides.push_back(put_in(lower(side, symbols), given));
  const bool are_expressions = left.operators.empty();
  std::vector<ex> bases = doubtful_bases(sides, symbols);
  if (are_expressions) std::erase_if(bases, [&](const ex& base) { return is_in_logarithm(base, sides); });
  const bool is_identity = are_expressions && given.empty() && agrees_for_negative(bases, sides);
  if (bases.empty() || is_identity || proof.verdict == Verdict::approximation) return proof;
  return undecided("a power with a symbolic exponent, of " + print(bases.front(), Notation::plain, symbols) +
                   ", which may be negative: that has values for some exponents only");
}

}  // namespace rederive
