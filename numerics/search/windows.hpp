// Every amplitude window in which a pulse overturns the block.
#pragma once

#include <numerics/motion/overturning.hpp>
#include <numerics/search/stations.hpp>
#include <optional>
#include <vector>

namespace rederive::numerics {

/// An interval of amplitudes a_p/(alpha g) that overturn with one code; `to` is empty if it reaches the
/// largest one asked.
struct Window {
  double from;
  std::optional<double> to;
  int code;
};

/// Returns the relative error of an edge: linear edges come from closed forms in 64 binary digits, nonlinear
/// ones from an integration.
constexpr double exactness_of_edges(Model model) { return model == Model::linear ? 1e-12 : 1e-10; }

/// Returns all windows between start_level and `largest`, in order.
///
/// Along a fixed itinerary (impacts during the pulse) both margins are continuous in the amplitude. Gaps are
/// halved, all together, where the itinerary or the code changes and where a margin, seen through its second
/// difference, might reach zero in between; each edge is then enclosed in neighbouring numbers, see
/// changes_between. Below the first station that overturns, windows among chains of impacts are looked for by
/// stations_below. Beside each amplitude at which a chain of impacts just does not come to rest, windows are
/// looked for down to a distance of 1e-9. Windows narrower than narrowest_found may be missing, and those
/// narrower than exactness_of_edges are left out. Throws std::invalid_argument unless 0 < omega_p/p and
/// 0 < largest <= 1e6, and Stopped once `stop` is true.
std::vector<Window> overturning_windows(const PulseCase& asked, const WindowSearch& search = {});

/// Returns the width, in units of alpha g, below which a window may be missing from the result of a search.
/// It is less for the least amplitude alone.
double narrowest_found(const WindowSearch& search);

/// Returns the window of the smallest amplitude, if there is one.
std::optional<Window> least_window(const std::vector<Window>& windows);

}  // namespace rederive::numerics
