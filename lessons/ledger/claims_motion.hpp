// Motions that several checks look at.
#pragma once

#include <numerics/overturning.hpp>

namespace rederive {

/// 400 states of the block from the start of the pulse of that amplitude to its end.
std::vector<Sample> samples_at(const PulseCase& asked, double amplitude);
/// The whole motion of the paper's nonlinear block from rest under a ground motion, with its events.
Response motion_under(const GroundMotion& ground);
/// The pulse of a case, as ground motion.
GroundMotion ground_of(const PulseCase& asked, double amplitude);
/// The least and the largest H/V while the pulse lasts, from the corrected (47); infinite where V <= 0.
struct FrictionRange {
  double least, most;
};
FrictionRange friction_range(const PulseCase& asked, double amplitude);

}  // namespace rederive
