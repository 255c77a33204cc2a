// Equations and inequalities, compared as residuals: left minus right, or what must be positive.
#pragma once

#include <derivations/algebra/sample.hpp>

namespace rederive {

/// What a residual must be for its relation to hold.
enum class Claim { zero, positive, not_negative };

/// Two residuals, and what else is known of them.
struct Residuals {
  Pair pair;
  Claim left, right;
  GiNaC::ex inner_left,
      inner_right;  ///< the same without increasing functions around both sides (unwrap.hpp)
  std::optional<GiNaC::ex> squared_left, squared_right;  ///< of these, where no side is negative
  std::vector<GiNaC::ex> left_divisors, right_divisors;  ///< what the statements divide by: not zero where
                                                         ///< they mean anything
};

/// The same statement, up to a factor that cannot vanish (for inequalities: that is positive)? Else a witness
/// at which one holds and the other fails.
Proof prove_residuals(const Residuals& residuals, const Symbols& symbols);

/// Whether a factor alone proves it: of the residuals without functions around both sides, which are shorter
/// and are tried first, or as they stand.
bool differ_by_some_factor(const Residuals& residuals, const Symbols& symbols);

/// A number that two residuals may differ by: left/right at three points, if it is one and the same multiple
/// of 1/12 at all of them, to about 35 decimal places, and not 0. That proves nothing.
std::optional<GiNaC::numeric> number_between(const GiNaC::ex& left, const GiNaC::ex& right,
                                             const Symbols& symbols);

/// Whether a whole exponent is above 8 in size. x^64 - y^64 has a factor that takes long to find, and is not
/// needed where x^2 - y^2 does: with such powers functions are taken off first.
bool has_high_power(const GiNaC::ex& residual);

/// Whether what a residual asks for holds at all points of the declared ranges, or at none; nothing where
/// neither is known.
std::optional<bool> settled(const GiNaC::ex& residual, Claim claim, const Symbols& symbols);
/// The same of a residual whose sides may be without the functions around them; then of the whole, too.
std::optional<bool> settled(const GiNaC::ex& inner, const GiNaC::ex& whole, Claim claim,
                            const Symbols& symbols);

/// Proofs with these verdicts, and nothing in them but what is given here. `factor` may be empty.
Proof proved(std::string factor, std::string reason);
Proof refuted(Witness witness, std::string reason);
Proof undecided(std::string reason);
/// "; an assumption on the sign of x may decide it": symbols under roots, in logarithms and between bars that
/// may be of either sign; empty if there are none.
std::string sign_that_may_decide(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive
