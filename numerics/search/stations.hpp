// Where a search for overturning windows goes: how far and how closely, and the outcomes at single
// amplitudes.
#pragma once

#include <atomic>
#include <functional>
#include <numerics/motion/overturning.hpp>
#include <stdexcept>
#include <vector>

namespace rederive::numerics {

struct WindowSearch {
  double largest = 12;      ///< the largest amplitude asked
  int stations = 768;       ///< first amplitudes tried, at least 1, crowded towards the smallest
  double narrowest = 2e-6;  ///< below this width nothing more is looked for
  double narrowest_turn =
      1e-5;  ///< to this width a change of the itinerary is followed, whatever the margins
  double glance =
      1e-9;  ///< tolerance of the kernel while it looks for windows; edges are found exactly afterwards
  int threads = 1;  ///< at least 1
  bool least =
      false;  ///< find the window of the smallest amplitude alone, from below, and leave its `to` empty
  const std::atomic<bool>* stop = nullptr;  ///< when it turns true, Stopped is thrown soon
  std::function<void(int motions)> progress =
      {};  ///< called with the number of motions followed since the last call
};

/// Thrown when a search is stopped before its end.
struct Stopped : std::runtime_error {
  Stopped() : std::runtime_error("the search was stopped") {}
};

/// The outcome at one amplitude. The margins are squeezed into (-1, 1), so that their steep parts do not hide
/// the rest.
struct Station {
  double amplitude = 0;
  Outcome outcome;
  double outward = -1, returning = -1;
  int code() const { return outcome.code; }
};

/// Returns the stations at these amplitudes. A search that can be stopped or watched follows some of them at
/// a time. Throws Stopped.
std::vector<Station> stations_at(const PulseCase& asked, const std::vector<double>& amplitudes,
                                 const WindowSearch& search = {});

/// The amplitudes between two stations.
struct Gap {
  Station low, high;
  double width() const { return high.amplitude - low.amplitude; }
};

/// Returns for each gap a row of stations that divide it into `parts` parts; the row begins and ends with the
/// ends of the gap.
std::vector<std::vector<Station>> parted(const PulseCase& asked, const std::vector<Gap>& gaps, int parts,
                                         const WindowSearch& search = {});

/// Returns stations below `overturns`, a station that overturns, down to `lowest`; each window found there
/// contains one.
///
/// The energy with which the pulse leaves the block is a continuous function of the amplitude. If a chain of
/// impacts lasts until the last push of the pulse begins, this function is a row of hills, one hill for every
/// two impacts of the chain. The hills become narrower towards the amplitude at which the chain just comes to
/// rest, or, at e = 1, towards the amplitude at which nothing moves. The search finds each hill by the number
/// of impacts before the last push, and climbs it; a top that overturns is a window. Downwards the hills
/// become lower. Once they have done so over several groups, each of more hills than the one before, the
/// search ends.
std::vector<Station> stations_below(const PulseCase& asked, const WindowSearch& search, double lowest,
                                    const Station& overturns);

}  // namespace rederive::numerics
