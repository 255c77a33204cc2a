// The outcomes at single amplitudes from which a search for windows goes on.
#pragma once

#include <numerics/motion/overturning.hpp>
#include <numerics/search/window_search.hpp>
#include <vector>

namespace rederive::numerics {

/// The outcome at one amplitude, the margins squeezed into (-1, 1) so that their steep parts do not hide the
/// rest.
struct Station {
  double amplitude = 0;
  Outcome outcome;
  double outward = -1, returning = -1;
  int code() const { return outcome.code; }
};

/// The stations at these amplitudes, followed some at a time where the search may be stopped or watched, and
/// by as many threads as it has.
std::vector<Station> stations_at(const PulseCase& asked, const std::vector<double>& amplitudes,
                                 const WindowSearch& search = {});

/// Between two stations.
struct Gap {
  Station low, high;
  double width() const { return high.amplitude - low.amplitude; }
};

/// Parts all gaps together, each into `parts`: the stations of each, its ends among them.
std::vector<std::vector<Station>> parted(const PulseCase& asked, const std::vector<Gap>& gaps, int parts,
                                         const WindowSearch& search = {});

}  // namespace rederive::numerics
