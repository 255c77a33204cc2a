#include <algorithm>
#include <derivations/algebra/conditions.hpp>
#include <derivations/algebra/elimination.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/print.hpp>
#include <derivations/algebra/rearrange.hpp>
#include <derivations/algebra/residuals.hpp>
#include <lessons/ledger/domain.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

bool never_holds(const Condition& condition, const std::vector<Given>& given, const Symbols& symbols) {
  return condition.relation != "!=" && settled(put_in(condition.value, given), claim_of(condition.relation),
                                               symbols) == std::optional(false);
}

/// A base that may be negative, with an exponent that is no number.
std::optional<ex> doubtful_base(const ex& e, const Symbols& symbols) {
  for (auto part = e.preorder_begin(); part != e.preorder_end(); ++part)
    if (GiNaC::is_a<GiNaC::power>(*part) && has_symbol(part->op(1)) && !is_nonnegative(part->op(0), symbols))
      return part->op(0);
  return std::nullopt;
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
  if (left.operators.empty()) return proof;
  for (const Relation* relation : {&left, &right})
    for (const Tree& side : relation->sides)
      if (const auto base = doubtful_base(put_in(lower(side, symbols), given), symbols))
        return undecided("a power with a symbolic exponent, of " + print(*base, Notation::plain, symbols) +
                         ", which may be negative: that has values for some exponents only");
  return proof;
}

}  // namespace rederive
