// Overturning after one impact: while the pulse lasts, (79) to (88), and after it, (89) to (96). The block
// starts from rest towards θ < 0, comes back, strikes at t_i and goes on with e times its angular velocity.
#pragma once

#include <derivations/rocking_block/overturning_without_impact.hpp>

namespace rederive::rocking_block {

/// Returns an expression in t at the time t_i of the impact.
inline GiNaC::ex at_impact(const GiNaC::ex& e) { return e.subs(t == t_i); }
/// Returns θ(t_i) during the pulse, times (1 + ω_p²/p²) sin ψ/α: (86) without its division, in ψ, ω_p, p and
/// t_i. It is 0 at an impact.
GiNaC::ex impact_during_pulse();
/// Returns the left side of (88) minus the right side, with t_i where the paper prints t, in ψ, ω_p, p, t_i
/// and e.
GiNaC::ex overturning_impact_during_pulse();
/// Returns θ(t_i)/α after the pulse, (92a), in ψ, ω_p, p and t_i. It is 0 at an impact.
GiNaC::ex impact_after_pulse();
/// Returns e θ̇(t_i)/(p α) − 1 after the pulse, (96), in ψ, ω_p, p, t_i and e.
GiNaC::ex overturning_impact_after_pulse();

/// Returns the time of the impact after the pulse that leads to the threshold, by (92a) and (96); it must not
/// lie before T_ex.
mechanics::Derivation time_of_critical_impact();

/// Add the derivations of (79) to (88), and of (89) to (96) with results of our own.
void derive_overturning_impact_during_pulse(paper::Derivations& rows);
void derive_overturning_impact_after_pulse(paper::Derivations& rows);

}  // namespace rederive::rocking_block
