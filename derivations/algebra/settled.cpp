// What always holds, or never.
#include <derivations/algebra/in_square.hpp>
#include <derivations/algebra/interval.hpp>
#include <derivations/algebra/quotient.hpp>
#include <derivations/algebra/residuals.hpp>
#include <derivations/algebra/slopes.hpp>
#include <derivations/algebra/vanish.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

std::optional<bool> settled_by_form(const ex& residual, Claim claim, const Symbols& symbols) {
  try {
    if (const int sign = sign_of(residual, symbols); sign != 0) return claim != Claim::zero && sign > 0;
    if (vanishes(residual, symbols)) return claim != Claim::positive;
    if (claim == Claim::not_negative && is_nonnegative(residual, symbols)) return true;
    if (claim == Claim::positive && is_nonnegative(-residual, symbols)) return false;
    const auto parts = checked_quotient(residual, 1, symbols);
    if (!parts) return std::nullopt;
    const Quotient factor = assess(*parts, {}, symbols);
    const bool never_zero = factor.zeros.empty();
    if (factor.sign == 0) return std::nullopt;
    if (claim == Claim::zero) return never_zero ? std::optional(false) : std::nullopt;
    const bool holds = factor.sign > 0,
               weak = holds == (claim == Claim::not_negative);  // 0 does not matter then
    return weak || never_zero ? std::optional(holds) : std::nullopt;
  } catch (const Undecidable&) {
    return std::nullopt;
  }
}

std::optional<bool> always_holds_in_square(const ex& residual, Claim claim, const Symbols& symbols) {
  try {
    const auto shown = claim == Claim::zero ? std::nullopt : shown_in_square(residual, symbols);
    return shown && (shown->is_strict || claim == Claim::not_negative) ? std::optional(true) : std::nullopt;
  } catch (const std::exception&) {  // outside of the class
    return std::nullopt;
  }
}

}  // namespace

std::optional<bool> settled(const ex& residual, Claim claim, const Symbols& symbols) {
  if (const auto holds = settled_by_form(residual, claim, symbols)) return holds;
  const auto slope = sign_by_slope(residual, symbols);
  if (!slope) return always_holds_in_square(residual, claim, symbols);
  const bool holds = slope->sign > 0, is_weak = holds == (claim == Claim::not_negative);  // 0 does not matter
  if (!slope->is_strict && (claim == Claim::zero || !is_weak)) return std::nullopt;
  return claim != Claim::zero && holds;
}

std::optional<bool> settled(const ex& inner, const ex& whole, Claim claim, const Symbols& symbols) {
  const auto result = settled(inner, claim, symbols);
  const bool is_other = !inner.is_equal(whole) && claim != Claim::zero && !has_high_power(whole);
  return !result && is_other ? settled(whole, claim, symbols) : result;
}

}  // namespace rederive
