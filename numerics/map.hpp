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

/// What follows the nonlinear model: outcome_at, or PulseBatch, which is some 30 times as fast. The linear
/// one has closed forms.
enum class Engine { gsl, taylor };

/// One column a task, so that an interruption keeps whole columns.
OutcomeMap outcome_map(const PulseCase& asked, std::vector<double> omega_ratios,
                       std::vector<double> amplitudes, Work work, Engine engine = Engine::taylor);

}  // namespace rederive::inline numeric
