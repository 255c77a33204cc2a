// The outcome over a grid of omega_p/p and amplitude.
#pragma once

#include <numerics/overturning.hpp>
#include <numerics/parallel.hpp>
#include <vector>

namespace rederive::inline numeric {

struct OutcomeMap {
  std::vector<double> omega_ratios, amplitudes;
  std::vector<std::vector<int>> codes;  ///< codes[omega][amplitude]; empty where interrupted
};

/// One column a task, so that an interruption keeps whole columns.
OutcomeMap outcome_map(const PulseCase& asked, std::vector<double> omega_ratios,
                       std::vector<double> amplitudes, Work work);

}  // namespace rederive::inline numeric
