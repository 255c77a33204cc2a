// Thresholds against omega_p/p.
#pragma once

#include <numerics/motion/parallel.hpp>
#include <numerics/search/windows.hpp>

namespace rederive::numerics {

/// The least amplitude that overturns and its code; the least without impact (|code| = 1); the least and the
/// largest after one impact (|code| = 2). Empty = none up to the largest amplitude asked, or no end below it.
struct SpectrumPoint {
  double omega_ratio = 0;
  std::optional<double> minimum, mode1, mode2_lower, mode2_upper;
  int code = 0;
  bool done = false;
};

SpectrumPoint spectrum_point(const PulseCase& asked, const WindowSearch& search = {});

/// One point for each of `omega_ratios`; `work` gives threads, stop and progress.
std::vector<SpectrumPoint> spectrum(const PulseCase& asked, const std::vector<double>& omega_ratios,
                                    const WindowSearch& search, Work work);

}  // namespace rederive::numerics
