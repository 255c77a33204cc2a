// Where the code changes between stations, each change between neighbouring numbers.
#pragma once

#include <numerics/stations.hpp>
#include <vector>

namespace rederive::inline numeric {

/// So many amplitudes are asked at once at least, to keep the lanes of the kernel busy.
constexpr int together = 16;

/// The changes of code along stations that are in order of their amplitudes, each enclosed in neighbouring
/// numbers.
///
/// The kernel narrows all gaps together. In the linear model its changes are then confirmed by closed forms,
/// unless a motion has so many impacts that these take too long; there the kernel is right to 1e-14.
std::vector<Gap> changes_between(const PulseCase& asked, std::vector<Station> stations,
                                 const WindowSearch& search);

}  // namespace rederive::inline numeric
