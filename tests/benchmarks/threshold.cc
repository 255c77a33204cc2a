// Thresholds and spectra of the nonlinear model beside the second method, GSL: rows of a Markdown table.
#include <cmath>
#include <numerics/search/grid.hpp>
#include <thread>

#include "timing.hpp"

using namespace rederive::numerics;
using namespace rederive::benchmarks;

namespace {

PulseCase at(double omega_ratio, Engine engine) {
  PulseCase asked = asked_with(Model::nonlinear);
  asked.omega_ratio = omega_ratio, asked.engine = engine;
  return asked;
}

std::vector<double> edges(const std::vector<Window>& windows) {
  std::vector<double> all;
  for (const Window& window : windows) all.push_back(window.from), all.push_back(window.to.value_or(0));
  return all;
}

std::vector<double> thresholds(double omega_ratio, Engine engine, bool least, int threads = 1) {
  return edges(overturning_windows(at(omega_ratio, engine), {.threads = threads, .least = least}));
}

std::vector<double> least_spectrum(int points, Engine engine) {
  std::vector<double> found;
  for (const SpectrumPoint& point : spectrum(at(1, engine), evenly(0.5, 10, points), {.least = true}, {}))
    found.push_back(point.minimum.value_or(0));
  return found;
}

/// Results first, then times.
void compare(const std::string& work, const std::function<std::vector<double>(Engine)>& find, int rounds) {
  const std::vector<double> mine = find(Engine::taylor), other = find(Engine::gsl);
  double apart = mine.size() == other.size() ? 0 : INFINITY;
  for (std::size_t i = 0; i < std::min(mine.size(), other.size()); ++i)
    if (other[i] != 0) apart = std::max(apart, std::fabs(mine[i] / other[i] - 1));
  const auto times = in_turns({[&] { find(Engine::taylor); }, [&] { find(Engine::gsl); }}, rounds);
  fmt::print("| {} | this, kernels | {:.3g} | {:.1f} | {:.1g} |\n", work, 1e3 * times[0], times[1] / times[0],
             apart);
  fmt::print("| {} | this, --engine gsl | {:.4g} | 1 | |\n", work, 1e3 * times[1]);
}

}  // namespace

int main() {
  const int all = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  for (const double ratio : {1.0, 3.0, 6.0}) {
    const std::string work = fmt::format("all windows, ω_p/p = {:g}", ratio);
    compare(
        work, [&](Engine engine) { return thresholds(ratio, engine, false); }, 3);
    if (all == 1) continue;
    const auto on_all = [&](Engine engine) {
      return thresholds(ratio, engine, false, engine == Engine::taylor ? all : 1);
    };
    compare(fmt::format("{}, {} threads to GSL's one", work, all), on_all, 3);
  }
  compare(
      "least threshold, ω_p/p = 3", [](Engine engine) { return thresholds(3, engine, true); }, 3);
  compare(
      "spectrum of 10 least thresholds", [](Engine engine) { return least_spectrum(10, engine); }, 1);
}
