// The linear model under a pulse and after it: (56) to (64), (97) to (100).
#pragma once

#include <derivations/mechanics/linear_motion.hpp>
#include <derivations/rocking_block/equation_of_motion.hpp>
#include <derivations/rocking_block/pulse.hpp>

namespace rederive::rocking_block {

/// a_p for which the linear block, at rest and upright, is about to move at t = 0: α g/sin ψ or α g/cos ψ.
Given amplitude(Pulse pulse);
/// e with that amplitude put in for a_p.
GiNaC::ex with_amplitude(const GiNaC::ex& e, Pulse pulse);

/// (21a) or (21b) to first order in α, θ and a_p/g: (56a), (56b), (61a), (61b), (97).
LinearEquation linear_equation(Side side, Pulse pulse);
/// The same with another ground acceleration, given as an expression of t and proportional to a_p.
LinearEquation linear_equation_under(Side side, const GiNaC::ex& ground);
/// θ(t) with the constants of the paper: A_1 sinh p t + A_2 cosh p t + … (θ < 0), A_3, A_4 (θ > 0).
GiNaC::ex forced_motion(Side side, Pulse pulse);
/// Their values from θ(0) = theta_0, θ̇(0) = thetadot_0, with the amplitude put in: (58), (100).
Constants forced_constants(Side side, Pulse pulse);
/// θ(t) under the pulse for any amplitude a_p, from theta_0 and thetadot_0 at t = 0: no names of constants
/// left.
GiNaC::ex linear_response(Side side, Pulse pulse);
/// The same by the sines and cosines of half the phases, in which a short stretch of motion is not the small
/// difference of large terms: cosh p t − 1 = 2 sinh²(p t/2), cos ω_p t − 1 = −2 sin²(ω_p t/2) …
GiNaC::ex by_half_phases(const GiNaC::ex& response);
/// The names of the constants of free motion: Abar_1, Abar_2 or Abar_3, Abar_4.
Constants free_names(Side side);
/// θ(t) of free motion from t_o: Abar_1 sinh p(t − t_o) + Abar_2 cosh p(t − t_o) − α, or Abar_3, Abar_4 and +
/// α.
GiNaC::ex free_motion(Side side);
/// The part of a free motion about start that grows like e^{p(t − start)}; it decides on which side it ends.
GiNaC::ex growing_part(const GiNaC::ex& free_motion, const GiNaC::ex& start);

Derivation equation_57a();
Derivation equation_57b();
Derivation equation_58a();
Derivation equation_58b();
Derivation equation_58c();
Derivation equation_58d();
Derivation equation_59a();
Derivation equation_59b();
Derivation equation_61b();
Derivation equation_62a();
Derivation equation_62b();
Derivation equation_64a();
Derivation equation_64b();
Derivation equation_64c();
Derivation equation_64d();

/// (56) to (64).
Derivations derivations_of_linear_response();

}  // namespace rederive::rocking_block
