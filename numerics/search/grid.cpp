#include <algorithm>
#include <cstdlib>
#include <numerics/motion/batch.hpp>
#include <numerics/search/grid.hpp>
#include <optional>

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

OutcomeMap outcome_map(const PulseCase& asked, std::vector<double> omega_ratios,
                       std::vector<double> amplitudes, Work work, MapKeeper keeper) {
  OutcomeMap map{std::move(omega_ratios), std::move(amplitudes), std::move(keeper.known)};
  const std::size_t columns = map.omega_ratios.size(), rows = map.amplitudes.size();
  map.codes.resize(columns);
  std::optional<PulseBatch> batch;
  if (asked.engine == Engine::taylor) batch.emplace(asked, map.amplitudes);
  // Lanes stay full while there are enough motions to fill them with; few enough stay in the cache.
  const std::size_t workers =
                        static_cast<std::size_t>(work.threads) * static_cast<std::size_t>(work.processes),
                    together = batch ? std::clamp(columns / (8 * workers), std::size_t{1},
                                                  1 + 400 / std::max(std::size_t{1}, rows))
                                     : 1;
  const auto first_of = [&](int i) { return static_cast<std::size_t>(i) * together; };
  const auto last_of = [&](int i) { return std::min(first_of(i + 1), columns); };
  const auto progress = std::move(work.progress);
  if (progress)
    work.progress = [&](int done) { progress(static_cast<int>(std::min(first_of(done), columns))); };
  work.count = static_cast<int>((columns + together - 1) / together);
  Task<int> task;
  task.is_known = [&](int i) {
    return rows > 0 && std::none_of(map.codes.begin() + static_cast<std::ptrdiff_t>(first_of(i)),
                                    map.codes.begin() + static_cast<std::ptrdiff_t>(last_of(i)),
                                    [](const std::vector<int>& column) { return column.empty(); });
  };
  task.compute = [&](int i) {
    const std::vector<double> ratios(map.omega_ratios.begin() + static_cast<std::ptrdiff_t>(first_of(i)),
                                     map.omega_ratios.begin() + static_cast<std::ptrdiff_t>(last_of(i)));
    std::vector<int> codes;
    if (batch)
      for (const auto& column : batch->codes(ratios)) codes.insert(codes.end(), column.begin(), column.end());
    else
      for (PulseCase here = asked; const double ratio : ratios) {
        here.omega_ratio = ratio;
        for (const double amplitude : map.amplitudes) codes.push_back(outcome_at(here, amplitude).code);
      }
    return codes;
  };
  task.accept = [&](int i, const std::vector<int>& codes) {
    for (std::size_t k = first_of(i); k < last_of(i); ++k) {
      const auto from = codes.begin() + static_cast<std::ptrdiff_t>((k - first_of(i)) * rows);
      map.codes[k].assign(from, from + static_cast<std::ptrdiff_t>(rows));
    }
    if (keeper.keep) keeper.keep(map, first_of(i), last_of(i));
  };
  share(work, task);
  return map;
}

}  // namespace rederive::numerics
