// Every amplitude window in which a pulse overturns the block.
#pragma once

#include <numerics/motion/overturning.hpp>
#include <numerics/search/window_search.hpp>
#include <optional>
#include <vector>

namespace rederive::numerics {

/// Amplitudes a_p/(alpha g) from .. to that overturn with one code; `to` is empty if it reaches the largest
/// asked.
struct Window {
  double from;
  std::optional<double> to;
  int code;
};

/// Relative: linear edges come from closed forms in 64 binary digits, nonlinear ones from an integration.
constexpr double exactness_of_edges(Model model) { return model == Model::linear ? 1e-12 : 1e-10; }

/// All windows between start_level and `largest`, in order.
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

/// Windows narrower than this, in units of alpha g, may be missing from what a search finds; below the least
/// amplitude alone it looks for narrower ones than everywhere.
double narrowest_found(const WindowSearch& search);

/// The window of the smallest amplitude, if any.
std::optional<Window> least_window(const std::vector<Window>& windows);

}  // namespace rederive::numerics
