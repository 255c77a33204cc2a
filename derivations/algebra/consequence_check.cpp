#include <algorithm>
#include <derivations/algebra/cofactors.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/phases.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/vanish.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

/// By its range, or part by part.
bool is_never_negative(const ex& e, const Symbols& symbols) {
  if (is_nonnegative(e, symbols)) return true;
  const auto parts = checked_quotient(e, 1, symbols);
  return parts && assess(*parts, {}, symbols).sign > 0;
}

/// What the term is worth: 0 for an equation, else not negative; +1 where it is positive.
std::optional<int> sign_of_term(const Summand& term, const std::vector<Asked>& links,
                                const Symbols& symbols) {
  const auto has = [&](Claim claim) { return [&, claim](std::size_t k) { return links[k].claim == claim; }; };
  if (std::any_of(term.links.begin(), term.links.end(), has(Claim::zero))) return 0;
  if (!is_never_negative(term.factor, symbols)) return std::nullopt;
  const bool is_strict = std::all_of(term.links.begin(), term.links.end(), has(Claim::positive));
  return is_strict && sign_of(term.factor, symbols) > 0 ? 1 : 0;
}

bool has_only_equations(const Consequence& why, const std::vector<Asked>& links) {
  return why.more.is_zero() && std::all_of(why.terms.begin(), why.terms.end(), [&](const Summand& term) {
           return std::any_of(term.links.begin(), term.links.end(),
                              [&](std::size_t k) { return links[k].claim == Claim::zero; });
         });
}

}  // namespace

bool shows(const Consequence& why, const Asked& target, const std::vector<Asked>& links,
           const std::vector<ex>& divisors, const Symbols& symbols) {
  ex sum = why.more;
  bool is_positive = sign_of(why.more, symbols) > 0, is_weak = is_never_negative(why.more, symbols);
  for (const Summand& term : why.terms) {
    ex product = term.factor;
    for (const std::size_t k : term.links) product *= links[k].residual;
    sum += product;
    const auto sign = sign_of_term(term, links, symbols);
    is_weak = is_weak && sign, is_positive = is_positive || sign == 1;
  }
  const ex goal = why.squared ? ex(-GiNaC::pow(target.residual, 2)) : target.residual;
  if (!vanishes(why.times * goal - sum, symbols)) return false;
  if (target.claim == Claim::zero && !why.squared)
    return is_never_zero(why.times, divisors, symbols) && has_only_equations(why, links);
  if (target.claim == Claim::positive)
    return !why.squared && is_weak && is_positive && is_never_negative(why.times, symbols);
  return is_weak && sign_of(why.times, symbols) > 0;
}

}  // namespace rederive
