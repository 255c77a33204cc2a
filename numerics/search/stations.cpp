#include <cmath>
#include <numerics/motion/batch.hpp>
#include <numerics/search/stations.hpp>

namespace rederive::numerics {
namespace {

double squeezed(Real margin) { return static_cast<double>(margin / (1 + std::abs(margin))); }

}  // namespace

std::vector<Station> stations_at(const PulseCase& asked, const std::vector<double>& amplitudes,
                                 const WindowSearch& search) {
  const auto end = amplitudes.end();
  const bool at_once = search.stop == nullptr && !search.progress;
  const std::ptrdiff_t some = at_once ? end - amplitudes.begin() : 64 * search.threads;
  std::vector<Station> stations;
  for (auto from = amplitudes.begin(); from != end;) {
    if (search.stop != nullptr && *search.stop) throw Stopped();
    const auto to = from + std::min(some, end - from);
    for (const Outcome& outcome : outcomes_at(asked, {from, to}, search.threads))
      stations.push_back({amplitudes[stations.size()], outcome, squeezed(outcome.margins.outward),
                          squeezed(outcome.margins.returning)});
    if (search.progress) search.progress(static_cast<int>(to - from));
    from = to;
  }
  return stations;
}

std::vector<std::vector<Station>> parted(const PulseCase& asked, const std::vector<Gap>& gaps, int parts,
                                         const WindowSearch& search) {
  std::vector<double> amplitudes;
  for (const auto& [low, high] : gaps)
    for (int i = 1; i < parts; ++i)
      amplitudes.push_back(std::lerp(low.amplitude, high.amplitude, static_cast<double>(i) / parts));
  const std::vector<Station> found = stations_at(asked, amplitudes, search);
  std::vector<std::vector<Station>> rows;
  auto next = found.begin();
  for (const auto& [low, high] : gaps) {
    std::vector<Station>& row = rows.emplace_back(1, low);
    for (int i = 1; i < parts; ++i, ++next)
      if (row.back().amplitude < next->amplitude && next->amplitude < high.amplitude) row.push_back(*next);
    row.push_back(high);
  }
  return rows;
}

}  // namespace rederive::numerics
