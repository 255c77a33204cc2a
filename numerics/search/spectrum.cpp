#include <cstdlib>
#include <numerics/search/spectrum.hpp>

namespace rederive::numerics {

SpectrumPoint spectrum_point(const PulseCase& asked, const WindowSearch& search) {
  SpectrumPoint point;
  point.omega_ratio = asked.omega_ratio;
  const auto windows = overturning_windows(asked, search);
  if (const auto least = least_window(windows)) point.minimum = least->from, point.code = least->code;
  for (const Window& window : windows) {
    if (std::abs(window.code) == 1 && !point.mode1) point.mode1 = window.from;
    if (std::abs(window.code) != 2) continue;
    if (!point.mode2_lower) point.mode2_lower = window.from;
    point.mode2_upper = window.to;
  }
  point.done = true;
  return point;
}

std::vector<SpectrumPoint> spectrum(const PulseCase& asked, const std::vector<double>& omega_ratios,
                                    const WindowSearch& search, Work work) {
  std::vector<SpectrumPoint> points(omega_ratios.size());
  work.count = static_cast<int>(omega_ratios.size());
  Task<SpectrumPoint> task;
  task.compute = [&](int i) {
    PulseCase here = asked;
    here.omega_ratio = omega_ratios[static_cast<std::size_t>(i)];
    return std::vector{spectrum_point(here, search)};
  };
  task.accept = [&](int i, const std::vector<SpectrumPoint>& found) {
    points[static_cast<std::size_t>(i)] = found.front();
  };
  share(work, task);
  return points;
}

}  // namespace rederive::numerics
