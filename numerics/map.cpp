#include <algorithm>
#include <numerics/batch.hpp>
#include <numerics/map.hpp>
#include <optional>

namespace rederive::inline numeric {

OutcomeMap outcome_map(const PulseCase& asked, std::vector<double> omega_ratios,
                       std::vector<double> amplitudes, Work work) {
  OutcomeMap map{std::move(omega_ratios), std::move(amplitudes), {}};
  const auto columns = static_cast<int>(map.omega_ratios.size());
  map.codes.resize(map.omega_ratios.size());
  std::optional<PulseBatch> batch;
  if (asked.engine == Engine::taylor) batch.emplace(asked, map.amplitudes);
  // Lanes stay full while there are enough motions to fill them with; few enough stay in the cache.
  const int rows = std::max(1, static_cast<int>(map.amplitudes.size()));
  const int together = batch ? std::clamp(columns / (8 * work.threads), 1, 1 + 800 / rows) : 1;
  const auto progress = std::move(work.progress);
  if (progress) work.progress = [&](int done) { progress(std::min(done * together, columns)); };
  work.count = (columns + together - 1) / together;
  for_each_index(work, [&](int i) {
    const auto first = map.omega_ratios.begin() + i * together,
               last = map.omega_ratios.begin() + std::min((i + 1) * together, columns);
    const auto column = map.codes.begin() + i * together;
    if (batch) {
      std::ranges::move(batch->codes({first, last}), column);
      return;
    }
    PulseCase here = asked;
    here.omega_ratio = *first;
    for (double amplitude : map.amplitudes) column->push_back(outcome_at(here, amplitude).code);
  });
  return map;
}

}  // namespace rederive::inline numeric
