// How far and how closely a search for overturning windows goes.
#pragma once

#include <atomic>
#include <functional>
#include <stdexcept>

namespace rederive::numerics {

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

}  // namespace rederive::numerics
