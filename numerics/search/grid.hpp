// Thresholds against omega_p/p, and outcomes over a grid of omega_p/p and amplitude.
#pragma once

#include <numerics/motion/overturning.hpp>
#include <numerics/motion/parallel.hpp>
#include <numerics/search/windows.hpp>
#include <vector>

namespace rederive::numerics {

/// The thresholds at one omega_p/p: the least amplitude that overturns, and its code; the least without
/// impact
/// (|code| = 1); the least and the largest after one impact (|code| = 2). A value is empty if no amplitude up
/// to the largest one asked has this outcome, or if the windows do not end below it.
struct SpectrumPoint {
  double omega_ratio = 0;
  std::optional<double> minimum, mode1, mode2_lower, mode2_upper;
  int code = 0;
  bool done = false;
};

SpectrumPoint spectrum_point(const PulseCase& asked, const WindowSearch& search = {});

/// Returns one point for each of `omega_ratios`; `work` gives threads, stop and progress. Points that a stop
/// leaves out are not `done`.
std::vector<SpectrumPoint> spectrum(const PulseCase& asked, const std::vector<double>& omega_ratios,
                                    const WindowSearch& search, Work work);

struct OutcomeMap {
  std::vector<double> omega_ratios, amplitudes;
  std::vector<std::vector<int>> codes;  ///< codes[omega][amplitude]; empty where interrupted
};

/// Keeps the columns of a map while it is computed.
struct MapKeeper {
  /// The codes of an earlier run, with an empty column for each that it did not compute; may be empty.
  std::vector<std::vector<int>> known = {};
  /// Called by one thread at a time when the columns first <= i < last are computed.
  std::function<void(const OutcomeMap&, std::size_t first, std::size_t last)> keep = {};
};

/// Returns the outcomes over the grid. Each task computes whole columns, so that an interruption keeps these.
OutcomeMap outcome_map(const PulseCase& asked, std::vector<double> omega_ratios,
                       std::vector<double> amplitudes, Work work, MapKeeper keeper = {});

}  // namespace rederive::numerics
