#include <numerics/batch.hpp>
#include <numerics/map.hpp>
#include <optional>

namespace rederive::inline numeric {

OutcomeMap outcome_map(const PulseCase& asked, std::vector<double> omega_ratios,
                       std::vector<double> amplitudes, Work work, Engine engine) {
  OutcomeMap map{std::move(omega_ratios), std::move(amplitudes), {}};
  map.codes.resize(map.omega_ratios.size());
  work.count = static_cast<int>(map.omega_ratios.size());
  std::optional<PulseBatch> batch;
  if (engine == Engine::taylor && asked.model == Model::nonlinear) batch.emplace(asked, map.amplitudes);
  for_each_index(work, [&](int i) {
    const auto column = static_cast<std::size_t>(i);
    PulseCase here = asked;
    here.omega_ratio = map.omega_ratios[column];
    std::vector<int> codes;
    if (batch)
      codes = batch->codes(here.omega_ratio);
    else
      for (double amplitude : map.amplitudes) codes.push_back(outcome_at(here, amplitude).code);
    map.codes[column] = std::move(codes);
  });
  return map;
}

}  // namespace rederive::inline numeric
