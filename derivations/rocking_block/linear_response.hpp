// The linear model under a pulse and after it: (52) to (64), (97) to (100).
#pragma once

#include <derivations/mechanics/linear_motion.hpp>
#include <derivations/rocking_block/equation_of_motion.hpp>

namespace rederive {

/// The ground acceleration: none, α_p sin(ω_p t + ψ) of (52), or α_p cos(ω_p t + ψ) of (97).
enum class Pulse { none, sine, cosine };
GiNaC::ex ground_acceleration(Pulse pulse);
/// When it ends: where the sine has come to 2π, the cosine to 3π/2.
GiNaC::ex end_of_pulse(Pulse pulse);
/// a_p for which the linear block, at rest and upright, is about to move at t = 0: α g/sin ψ or α g/cos ψ.
Given amplitude(Pulse pulse);

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
/// θ(t) of free motion from t_o: Abar_1 sinh p(t − t_o) + Abar_2 cosh p(t − t_o) − α, or Abar_3, Abar_4 and +
/// α.
GiNaC::ex free_motion(Side side);
/// The part of a free motion about start that grows like e^{p(t − start)}; it decides on which side it ends.
GiNaC::ex growing_part(const GiNaC::ex& free_motion, const GiNaC::ex& start);

Derivation equation_53a();
Derivation equation_53b();
Derivation equation_53c();
Derivation pulse_begins();
Derivation pulse_ends();
Derivation equation_54();
Derivation equation_55a();
Derivation equation_55b();
Derivation equation_56a();
Derivation equation_56b();
Derivation linear_amplitude();
Derivation equation_57a();
Derivation equation_57b();
Derivation equation_58a();
Derivation equation_58b();
Derivation equation_58c();
Derivation equation_58d();
Derivation equation_59a();
Derivation equation_59b();
Derivation equation_60_negative();
Derivation equation_60_positive();
Derivation equation_60_rate();
Derivation equation_61a();
Derivation equation_61b();
Derivation equation_62a();
Derivation equation_62b();
Derivation equation_63a();
Derivation equation_63b();
Derivation equation_64a();
Derivation equation_64b();
Derivation equation_64c();
Derivation equation_64d();
Derivation end_of_sine_pulse();

}  // namespace rederive
