// What the exercises on the built-in paper take from the paper and from the numerics.
#pragma once

#include <lessons/exercises/course.hpp>

namespace rederive::rocking_block {

/// The paper, what its names stand for, two derivations that it does not have, and the numeric functions
/// amplitude_without_impact (of omega, which is omega_p/p) and least_amplitude (of omega and, if it is not
/// 0.25, alpha).
const classroom::Course& course();

/// Derives e, in b and h, of a light block with a point mass in the middle of its top face: the moment of the
/// momentum about the new corner is kept.
mechanics::Derivation mass_at_the_top();
/// The condition of (71) for a pulse that stops after half a sine, when its argument is pi.
mechanics::Derivation half_sine();

}  // namespace rederive::rocking_block
