// The two frequencies at which overturning after one impact changes, under a one-sine pulse from rest.
#pragma once

#include <numerics/motion/overturning.hpp>
#include <optional>

namespace rederive::rocking_block {

/// omega_p/p and a_p/(alpha g), both by simulation.
struct SpecialPoint {
  double omega_ratio, amplitude;
};

/// Where the impact that just overturns comes exactly at the end of the pulse: below, it comes during the
/// pulse, (86)&(88), above, after it, (92a)&(96). Empty if there is none with 1 < omega_p/p < 60.
std::optional<SpecialPoint> handover(const numerics::PulseCase& asked);

/// Where the window of overturning after one impact shrinks to a point: just above that omega_p/p no
/// amplitude up to 200 overturns so. (A nonlinear block can be overturned so again by pulses that are very
/// much shorter and stronger.) The amplitude is right to seven digits. Empty if there is none with 1 <
/// omega_p/p < 60, so for e = 1.
std::optional<SpecialPoint> end_of_mode_2(const numerics::PulseCase& asked);

}  // namespace rederive::rocking_block
