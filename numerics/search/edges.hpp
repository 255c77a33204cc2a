// Where the code changes between stations, each change between neighbouring numbers.
#pragma once

#include <numerics/search/roots.hpp>
#include <numerics/search/stations.hpp>
#include <vector>

namespace rederive::numerics {

/// So many amplitudes are asked at once at least, to keep the lanes of the kernel busy.
constexpr int together = 16;

/// The changes of code along stations that are in order of their amplitudes, each enclosed in neighbouring
/// numbers.
///
/// The kernel narrows all gaps together. In the linear model its changes are then confirmed by closed forms,
/// unless a motion has so many impacts that these take too long; there the kernel is right to 1e-14.
std::vector<Gap> changes_between(const PulseCase& asked, std::vector<Station> stations,
                                 const WindowSearch& search);

/// The same as edges are found: the linear model by closed forms, the nonlinear one by steps so exact that
/// rounding is all that is left, where the engine is taylor.
PulseCase exactly(PulseCase asked);

/// Where the code changes: `inside` the code, which holds at the first of two amplitudes and not at the
/// other; else std::invalid_argument is thrown.
Change edge_of_code(const PulseCase& asked, int code, double inside, double outside);

}  // namespace rederive::numerics
