// Overturning without impact under one sine: (65) to (71) for θ < 0, (72) to (78) for θ > 0, (104).
#pragma once

#include <derivations/rocking_block/linear_response.hpp>

namespace rederive::rocking_block {

/// An equation of the form left = e^{−…}, with the terms without an exponential on the left.
struct ThresholdEquation {
  GiNaC::ex left, right;
  GiNaC::ex residual() const { return left - right; }
};

/// Returns the condition for the critical motion of a block that starts with theta_0 and thetadot_0 at t = 0
/// and is still on that side at the time `end`: (71), (78), (103), (104), in ψ, ω_p, p and α. The ground
/// acceleration is `ground`, an expression in t, until `end`, and 0 after it; `amplitude` says what a_p is.
ThresholdEquation threshold_without_impact(Side side, const GiNaC::ex& ground,
                                           const language::Given& amplitude, const GiNaC::ex& end);
/// Returns the condition under the one-sine or one-cosine pulse of the paper.
ThresholdEquation threshold_without_impact(Side side, Pulse pulse);

/// Returns rate/p + (angle ± α), which is 0 at T_ex in the critical case.
GiNaC::ex critical_sum(Side side, const GiNaC::ex& angle, const GiNaC::ex& rate);
/// Returns the velocity θ̇ for which critical_sum is 0: with it a free linear motion at θ just reaches the
/// corner, (68), (75).
GiNaC::ex linear_critical_rate(Side side);
/// Returns θ̇² at the impact to which free linear motion leads from θ and θ̇, for θ̇² − p²(θ ± α)² is constant
/// by (62) and (63).
GiNaC::ex linear_impact_rate_squared(Side side);
/// Return θ(T_ex) and θ̇(T_ex)/p in A_1, A_2 or in A_3, A_4.
GiNaC::ex angle_at_end(Side side, Pulse pulse);
GiNaC::ex rate_at_end(Side side, Pulse pulse);
/// Returns A_1 and A_2 of the motion from rest, (70), as substitutions.
GiNaC::lst constants_from_rest();
/// Returns the expression expanded and collected by cos ψ and sin ψ.
GiNaC::ex by_phase(const GiNaC::ex& e);
/// Returns the expression with exponentials in place of sinh and cosh.
GiNaC::ex in_exponentials(const GiNaC::ex& e);

mechanics::Derivation equation_68();
mechanics::Derivation equation_70a();
mechanics::Derivation equation_70b();

/// Adds the derivations of (65) to (78).
void derive_overturning_without_impact(paper::Derivations& rows);

}  // namespace rederive::rocking_block
