// The outcome over a grid of omega_p/p and amplitude.
#pragma once

#include <numerics/motion/overturning.hpp>
#include <numerics/motion/parallel.hpp>
#include <vector>

namespace rederive::numerics {

struct OutcomeMap {
  std::vector<double> omega_ratios, amplitudes;
  std::vector<std::vector<int>> codes;  ///< codes[omega][amplitude]; empty where interrupted
};

/// For a map that is kept while it grows.
struct MapKeeper {
  std::vector<std::vector<int>> known =
      {};  ///< codes of an earlier run, empty where it had none; or nothing at all
  /// Told of columns first <= i < last when they are there, by one thread at a time.
  std::function<void(const OutcomeMap&, std::size_t first, std::size_t last)> keep = {};
};

/// Some columns a task, so that an interruption keeps whole columns.
OutcomeMap outcome_map(const PulseCase& asked, std::vector<double> omega_ratios,
                       std::vector<double> amplitudes, Work work, MapKeeper keeper = {});

}  // namespace rederive::numerics
