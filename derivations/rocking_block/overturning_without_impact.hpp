// Overturning without impact under one sine: (65) to (71) for θ < 0, (72) to (78) for θ > 0, (104).
#pragma once

#include <derivations/rocking_block/linear_response.hpp>

namespace rederive::rocking_block {

/// An equation of the form left = e^{−…}: the terms without an exponential, and those with one on the right.
struct ThresholdEquation {
  GiNaC::ex left, right;
  GiNaC::ex residual() const { return left - right; }
};

/// The critical motion of a block that starts with theta_0, thetadot_0 at t = 0 and is still on that side at
/// `end`, when the ground acceleration `ground` (an expression of t) ceases: (71), (78), (103), (104). In ψ,
/// ω_p, p, α.
ThresholdEquation threshold_without_impact(Side side, const GiNaC::ex& ground, const Given& amplitude,
                                           const GiNaC::ex& end);
/// Under the one-sine or one-cosine pulse of the paper.
ThresholdEquation threshold_without_impact(Side side, Pulse pulse);

/// θ̇(T_ex)/p + (θ(T_ex) ± α), which vanishes in the critical case; θ and θ̇ as given.
GiNaC::ex critical_sum(Side side, const GiNaC::ex& angle, const GiNaC::ex& rate);
/// θ̇ for which critical_sum vanishes: with it a free linear motion at θ just reaches the corner, (68), (75).
GiNaC::ex linear_critical_rate(Side side);
/// θ̇² at the impact to which free linear motion leads from θ, θ̇: θ̇² − p²(θ ± α)² keeps its value, (62),
/// (63).
GiNaC::ex linear_impact_rate_squared(Side side);
/// θ(T_ex), θ̇(T_ex)/p with A_1, A_2 or A_3, A_4 in them.
GiNaC::ex angle_at_end(Side side, Pulse pulse);
GiNaC::ex rate_at_end(Side side, Pulse pulse);
/// A_1, A_2 of the motion from rest, (70), to put in.
GiNaC::lst constants_from_rest();
/// Expanded, and collected by cos ψ and sin ψ.
GiNaC::ex by_phase(const GiNaC::ex& e);
/// sinh and cosh by exponentials, products of exponentials joined.
GiNaC::ex in_exponentials(const GiNaC::ex& e);

Derivation equation_66a();
Derivation equation_66b();
Derivation equation_68();
Derivation equation_69a();
Derivation equation_69b();
Derivation equation_70a();
Derivation equation_70b();
Derivation equation_71();
Derivation equation_75();
Derivation equation_78();

/// (65) to (78).
Derivations derivations_of_overturning_without_impact();

}  // namespace rederive::rocking_block
