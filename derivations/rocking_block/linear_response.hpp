// The linear model under a pulse and after it: (56) to (64), (97) to (100).
#pragma once

#include <derivations/mechanics/linear_motion.hpp>
#include <derivations/rocking_block/equation_of_motion.hpp>
#include <derivations/rocking_block/pulse.hpp>

namespace rederive::rocking_block {

/// Returns the amplitude a_p for which the linear block, at rest and upright, is about to move at t = 0: α
/// g/sin ψ or α g/cos ψ.
language::Given amplitude(Pulse pulse);
/// Returns e with that amplitude in place of a_p.
GiNaC::ex with_amplitude(const GiNaC::ex& e, Pulse pulse);

/// Returns (21a) or (21b) to first order in α, θ and a_p/g: (56a), (56b), (61a), (61b) or (97).
mechanics::LinearEquation linear_equation(Side side, Pulse pulse);
/// Returns the same under the ground acceleration `ground`, an expression in t that is proportional to a_p.
mechanics::LinearEquation linear_equation_under(Side side, const GiNaC::ex& ground);
/// Returns θ(t) with the constants of the paper: A_1 sinh p t + A_2 cosh p t + … for θ < 0, A_3 and A_4 for θ
/// > 0.
GiNaC::ex forced_motion(Side side, Pulse pulse);
/// Returns the values of these constants for θ(0) = theta_0 and θ̇(0) = thetadot_0, with the amplitude: (58),
/// (100).
mechanics::Constants forced_constants(Side side, Pulse pulse);
/// Returns θ(t) under the pulse for any amplitude a_p, from theta_0 and thetadot_0 at t = 0, without names of
/// constants.
GiNaC::ex linear_response(Side side, Pulse pulse);
/// Returns the response in the sines and cosines of half the phases, so that a short motion is not the small
/// difference of large terms: cosh p t − 1 = 2 sinh²(p t/2), cos ω_p t − 1 = −2 sin²(ω_p t/2) …
GiNaC::ex by_half_phases(const GiNaC::ex& response);
/// Returns the names of the constants of free motion: Abar_1, Abar_2 or Abar_3, Abar_4.
mechanics::Constants free_names(Side side);
/// Returns θ(t) of free motion from t_o on: Abar_1 sinh p(t − t_o) + Abar_2 cosh p(t − t_o) − α, or the same
/// with Abar_3, Abar_4 and + α.
GiNaC::ex free_motion(Side side);
/// Returns the coefficient of e^{p(t − start)} in a free motion; its sign decides on which side the motion
/// ends.
GiNaC::ex growing_part(const GiNaC::ex& free_motion, const GiNaC::ex& start);

/// Return the derivations of the constants of the forced motion, (58), and of the free one, (64): of the
/// factor of sinh if `first`, else of the factor of cosh.
mechanics::Derivation forced_constant(Side side, bool first);
mechanics::Derivation free_constant(Side side, bool first);

/// Adds the derivations of (56) to (64).
void derive_linear_response(paper::Derivations& rows);

}  // namespace rederive::rocking_block
