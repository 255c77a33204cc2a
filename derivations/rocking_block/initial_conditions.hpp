// Initial conditions and the one-cosine pulse: (97) to (104), and what the cosine pulse does to a block at
// rest.
#pragma once

#include <derivations/rocking_block/overturning_without_impact.hpp>

namespace rederive::rocking_block {

/// (103) and (104): the threshold without impact from theta_0, thetadot_0, for θ > 0 under the cosine and for
/// θ < 0 under the sine.
ThresholdEquation overturning_cosine_pulse();
ThresholdEquation overturning_sine_pulse();
/// The cosine pulse from rest: the block stands until the acceleration has come to −α g, at phase π − ψ, then
/// turns towards θ > 0 until the pulse ends at phase 3π/2.
ThresholdEquation overturning_cosine_pulse_from_rest();

Derivation phase_of_cosine();

/// Results of our own: θ̈ just after t = 0 on the side θ > 0, for a block at rest under the cosine pulse:
/// negative, so it cannot turn there; when it does start; and the threshold that this motion has.
Derivation first_acceleration_to_the_right();
Derivation start_under_cosine();

/// (97) to (104), and results of our own.
Derivations derivations_of_initial_conditions();

}  // namespace rederive::rocking_block
