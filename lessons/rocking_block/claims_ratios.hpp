// The two frequencies at which overturning after one impact changes, under a one-sine pulse from rest.
#pragma once

#include <numerics/motion/overturning.hpp>
#include <optional>

namespace rederive::rocking_block {

/// A point of the diagram: omega_p/p and a_p/(alpha g), both by simulation.
struct SpecialPoint {
  double omega_ratio, amplitude;
};

/// Returns the point at which the impact that just overturns the block comes exactly at the end of the pulse.
/// Below, it comes during the pulse, (86)&(88); above, after it, (92a)&(96). Returns nothing if there is no
/// such point with 1 < omega_p/p < 60.
std::optional<SpecialPoint> handover(const numerics::PulseCase& asked);

/// Returns the point to which the window of overturning after one impact shrinks: just above that omega_p/p,
/// no amplitude up to 200 overturns the block so. (Pulses that are very much shorter and stronger can again
/// overturn a nonlinear block so.) The amplitude is right to seven digits. Returns nothing if there is no
/// such point with 1 < omega_p/p < 60, as for e = 1.
std::optional<SpecialPoint> end_of_mode_2(const numerics::PulseCase& asked);

}  // namespace rederive::rocking_block
