// Initial conditions and the one-cosine pulse: (97) to (104), and what the cosine pulse does to a block at
// rest.
#pragma once

#include <derivations/rocking_block/overturning_without_impact.hpp>

namespace rederive::rocking_block {

/// Return the thresholds without impact from theta_0 and thetadot_0: (103) for θ > 0 under the cosine pulse,
/// and (104) for θ < 0 under the sine pulse.
ThresholdEquation overturning_cosine_pulse();
ThresholdEquation overturning_sine_pulse();
/// Returns the threshold of the cosine pulse from rest. The block does not move until the acceleration is −α
/// g, at phase π − ψ; then it turns towards θ > 0 until the pulse ends at phase 3π/2.
ThresholdEquation overturning_cosine_pulse_from_rest();

/// Derives the phase ψ at which the cosine pulse has a share λ of its amplitude.
mechanics::Derivation phase_of_cosine();

/// Adds the derivations of (97) to (104), and of results of our own.
void derive_initial_conditions(paper::Derivations& rows);

}  // namespace rederive::rocking_block
