// Every amplitude window in which a pulse overturns the block.
#pragma once

#include <atomic>
#include <functional>
#include <numerics/overturning.hpp>
#include <numerics/roots.hpp>
#include <optional>
#include <stdexcept>
#include <vector>

namespace rederive::inline numeric {

/// Amplitudes a_p/(alpha g) from .. to that overturn with one code; `to` is empty if it reaches the largest
/// asked.
struct Window {
  double from;
  std::optional<double> to;
  int code;
};

struct WindowSearch {
  double largest = 12;      ///< the largest amplitude asked
  int stations = 768;       ///< first amplitudes tried, at least 1, crowded towards the smallest
  double narrowest = 2e-6;  ///< below this width nothing more is looked for
  double narrowest_turn =
      1e-5;              ///< to this width a change of the itinerary is followed, whatever the margins
  double glance = 1e-9;  ///< tolerance of a kernel that looks for them: an edge is found exactly afterwards
  int threads = 1;       ///< at least 1
  bool least = false;  ///< the window of the smallest amplitude alone, found from below; its `to` stays empty
  const std::atomic<bool>* stop = nullptr;         ///< when it turns true, Stopped is thrown soon
  std::function<void(int motions)> progress = {};  ///< told how many more motions have been followed
};

/// A search was ended before it was through.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("the search was stopped") {}
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

/// The same as edges are found: the linear model by closed forms, the nonlinear one by steps so exact that
/// rounding is all that is left, where the engine is taylor.
PulseCase exactly(PulseCase asked);

/// Where the code changes: `inside` the code, which holds at the first of two amplitudes and not at the
/// other; else std::invalid_argument is thrown.
Change edge_of_code(const PulseCase& asked, int code, double inside, double outside);

}  // namespace rederive::inline numeric
