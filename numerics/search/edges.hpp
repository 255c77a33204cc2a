// Where the code changes between stations, each change between neighbouring numbers.
#pragma once

#include <numerics/search/roots.hpp>
#include <numerics/search/stations.hpp>
#include <vector>

namespace rederive::numerics {

/// The least number of amplitudes that are followed together, which keeps the lanes of the kernel busy.
constexpr int together = 16;

/// Returns the changes of code along stations, which are in the order of their amplitudes; each change is
/// enclosed in neighbouring numbers.
///
/// The kernel narrows all gaps together. In the linear model, closed forms then confirm its changes, unless a
/// motion has so many impacts that they take too long; the kernel is right to 1e-14 there.
std::vector<Gap> changes_between(const PulseCase& asked, std::vector<Station> stations,
                                 const WindowSearch& search);

/// Returns `asked` with the method by which edges are found: closed forms for the linear model; for the
/// nonlinear one and the engine taylor, steps whose only error is rounding.
PulseCase exactly(PulseCase asked);

/// Returns the edge of the amplitudes with this code: its first number has the code, its second one has
/// another. Throws std::invalid_argument unless the code holds at the amplitude `inside` and not at
/// `outside`.
Change edge_of_code(const PulseCase& asked, int code, double inside, double outside);

}  // namespace rederive::numerics
