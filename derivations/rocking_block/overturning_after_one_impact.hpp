// Overturning after one impact: while the pulse lasts, (79) to (88), and after it, (89) to (96). The block
// starts from rest towards θ < 0, comes back, strikes at t_i and goes on with e times its angular velocity.
#pragma once

#include <derivations/rocking_block/overturning_without_impact.hpp>

namespace rederive::rocking_block {

/// A function of t at the time t_i of the impact.
inline GiNaC::ex at_impact(const GiNaC::ex& e) { return e.subs(t == t_i); }
/// θ(t_i) = 0 during the pulse, times (1 + ω_p²/p²) sin ψ/α: (86) without its division. In ψ, ω_p, p, t_i.
GiNaC::ex impact_during_pulse();
/// Left less right of (88), with t_i where the paper prints t. In ψ, ω_p, p, t_i, e.
GiNaC::ex overturning_impact_during_pulse();
/// θ(t_i)/α = 0 after the pulse: (92a). In ψ, ω_p, p, t_i.
GiNaC::ex impact_after_pulse();
/// e θ̇(t_i)/(p α) − 1 after the pulse: (96). In ψ, ω_p, p, t_i, e.
GiNaC::ex overturning_impact_after_pulse();

Derivation equation_79a();
Derivation equation_81();
Derivation equation_82();
Derivation equation_94a();
Derivation equation_94b();

/// Results of our own: (92a) and (96) without t_i. Its roots are the ends of the window of amplitudes that
/// overturn after an impact behind the pulse; the one with the larger amplitude bounds the window from above.
Derivation window_after_pulse();
/// The time of that impact, which must not lie before T_ex.
Derivation time_of_critical_impact();
/// At the threshold without impact, (71), a block that just comes back strikes with p α and is too slow.
Derivation velocity_near_first_mode();

/// (79) to (88), and (89) to (96) with results of our own.
Derivations derivations_of_overturning_impact_during_pulse();
Derivations derivations_of_overturning_impact_after_pulse();

}  // namespace rederive::rocking_block
