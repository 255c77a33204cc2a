// Maps beside the peers: build/tests/benchmark_map FOLDER. Rows of a Markdown table; into the folder, data
// for plots and some cells with their codes for peers in other languages. Each peer follows a part of the
// cells.
#include <fstream>
#include <memory>
#include <numerics/motion/batch.hpp>
#include <numerics/search/grid.hpp>

#include "peers.hpp"
#include "timing.hpp"

using namespace rederive::numerics;
using namespace rederive::benchmarks;

namespace {

struct Grid {
  explicit Grid(int count) : ratios(evenly(0.2, 10, count)), amplitudes(evenly(1, 12, count)) {}
  double cells() const { return static_cast<double>(ratios.size() * amplitudes.size()); }
  std::vector<double> ratios, amplitudes;
};

using Codes = std::vector<std::vector<int>>;

Codes mapped(const PulseCase& asked, const Grid& grid, int threads) {
  Work work;
  work.threads = threads;
  return outcome_map(asked, grid.ratios, grid.amplitudes, work).codes;
}

/// One column a time, as outcome_map does on one thread, but by the kernel given.
Codes mapped_by(const BatchKernel& kernel, const PulseCase& asked, const Grid& grid) {
  const PulseBatch batch(asked, grid.amplitudes, kernel);
  Codes codes;
  for (std::size_t i = 0; i < grid.ratios.size(); i += 3) {
    const auto first = grid.ratios.begin() + static_cast<std::ptrdiff_t>(i);
    for (auto& column : batch.codes({first, first + std::min<std::ptrdiff_t>(3, grid.ratios.end() - first)}))
      codes.push_back(std::move(column));
  }
  return codes;
}

struct Peer {
  std::string name;
  std::function<int(double omega, double amplitude)> code;
  std::size_t every;  ///< it follows one cell out of this many
};

Peer peer_of(const std::string& name, std::shared_ptr<Integrator> integrator, const PulseCase& asked,
             std::size_t every) {
  return {name, [=](double omega, double amplitude) { return code_by(*integrator, asked, omega, amplitude); },
          every};
}

std::vector<Peer> peers_of(const PulseCase& asked) {
  const double alpha = asked.block.alpha, tolerance = asked.tolerance;
  std::vector<Peer> peers{
      peer_of(fmt::format("GSL rk8pd, {:g}", tolerance), std::make_shared<Gsl>(alpha, tolerance), asked, 11),
      peer_of(fmt::format("odeint dopri5, {:g}", 10 * tolerance),
              std::make_shared<Odeint>(alpha, 10 * tolerance), asked, 11)};
#ifdef REDERIVE_SUNDIALS
  peers.push_back(peer_of(fmt::format("SUNDIALS CVODE, {:g}", tolerance),
                          std::make_shared<Sundials>(alpha, tolerance), asked, 61));
#endif
  if (asked.model == Model::nonlinear) {
    const auto gsl = std::make_shared<Gsl>(alpha, tolerance);
    gsl->decides_early = true;
    peers.push_back(peer_of(fmt::format("GSL rk8pd, {:g}, deciding as early", tolerance), gsl, asked, 11));
    return peers;
  }
  peers.push_back(peer_of("Runge-Kutta 4, 0.01", std::make_shared<LinearRungeKutta>(0.01), asked, 3));
  peers.push_back({"closed forms, long double",
                   [=](double omega, double amplitude) {
                     PulseCase here = asked;
                     here.omega_ratio = omega;
                     return outcome_at(here, amplitude).code;
                   },
                   61});
  return peers;
}

void for_cells(const Grid& grid, std::size_t every, const std::function<void(std::size_t, std::size_t)>& at) {
  const std::size_t rows = grid.amplitudes.size();
  for (std::size_t k = 0; k < grid.ratios.size() * rows; k += every) at(k / rows, k % rows);
}

void row(const std::string& work, const std::string& who, double rate, double base, std::size_t differing) {
  fmt::print("| {} | {} | {:.0f} | {:.2f} | {} |\n", work, who, rate, rate / base, differing);
}

/// The table of one model at one tolerance; the first peer is the unit.
void compare(Model model, double tolerance, int points) {
  const PulseCase asked = asked_with(model, tolerance);
  const Grid grid(points);
  const Codes codes = mapped(asked, grid, 1);
  const std::vector<Peer> peers = peers_of(asked);
  std::vector<std::function<void()>> contenders;
  std::vector<double> cells;
  std::vector<std::size_t> differing;
  std::vector<std::string> names;
  for (const Peer& peer : peers) {
    std::size_t differ = 0, count = 0;
    for_cells(grid, peer.every, [&](std::size_t i, std::size_t j) {
      ++count, differ += peer.code(grid.ratios[i], grid.amplitudes[j]) != codes[i][j] ? 1 : 0;
    });
    names.push_back(peer.name), cells.push_back(static_cast<double>(count)), differing.push_back(differ);
    contenders.push_back([&] {
      for_cells(grid, peer.every,
                [&](std::size_t i, std::size_t j) { peer.code(grid.ratios[i], grid.amplitudes[j]); });
    });
  }
  const auto add = [&](const std::string& name, std::function<Codes()> map) {
    const Codes found = map();
    std::size_t differ = 0;
    for_cells(grid, 1, [&](std::size_t i, std::size_t j) { differ += found[i][j] != codes[i][j] ? 1 : 0; });
    names.push_back(name), cells.push_back(grid.cells()), differing.push_back(differ);
    contenders.push_back([map = std::move(map)] { map(); });
  };
  for (const BatchKernel& kernel : batch_kernels())
    add(fmt::format("this, {}", kernel.name), [&] { return mapped_by(kernel, asked, grid); });
  add("this, outcome_map, 1 thread", [&] { return mapped(asked, grid, 1); });
  add("this, outcome_map, 2 threads", [&] { return mapped(asked, grid, 2); });
  const std::vector<double> times = in_turns(contenders);
  const std::string work = fmt::format(
      "{} map, {} × {}, {:g}", model == Model::linear ? "linear" : "nonlinear", points, points, tolerance);
  for (std::size_t i = 0; i < times.size(); ++i)
    row(work, names[i], cells[i] / times[i], cells[0] / times[0], differing[i]);
}

/// Microseconds a cell against the tolerance, and seconds against the points a side.
void curves(const std::string& folder) {
  std::ofstream against_tolerance(folder + "/cost-against-tolerance.dat"),
      against_size(folder + "/cost-against-size.dat");
  against_tolerance << "# tolerance, microseconds a cell: this, GSL, odeint\n";
  for (const double tolerance : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10, 1e-11, 1e-12, 1e-13}) {
    const PulseCase asked = asked_with(Model::nonlinear, tolerance);
    const Grid grid(100);
    Gsl gsl(asked.block.alpha, tolerance);
    Odeint odeint(asked.block.alpha, tolerance);
    const auto follow = [&](Integrator& by) {
      for_cells(grid, 41, [&](std::size_t i, std::size_t j) {
        code_by(by, asked, grid.ratios[i], grid.amplitudes[j]);
      });
    };
    const auto times =
        in_turns({[&] { mapped(asked, grid, 1); }, [&] { follow(gsl); }, [&] { follow(odeint); }}, 3);
    const double some = std::ceil(grid.cells() / 41);
    against_tolerance << fmt::format("{:g} {:.4g} {:.4g} {:.4g}\n", tolerance, 1e6 * times[0] / grid.cells(),
                                     1e6 * times[1] / some, 1e6 * times[2] / some);
  }
  against_size << "# points a side, seconds: nonlinear 1e-9, linear 1e-9\n";
  for (const int points : {50, 100, 200, 400, 800}) {
    const Grid grid(points);
    const auto times = in_turns({[&] { mapped(asked_with(Model::nonlinear, 1e-9), grid, 1); },
                                 [&] { mapped(asked_with(Model::linear, 1e-9), grid, 1); }},
                                3);
    against_size << fmt::format("{} {:.4g} {:.4g}\n", points, times[0], times[1]);
  }
}

/// Some cells for peers elsewhere.
void write_cells(const std::string& folder) {
  std::ofstream file(folder + "/cells.csv");
  const Grid grid(400);
  const Codes codes = mapped(asked_with(Model::nonlinear, 1e-9), grid, 1);
  for_cells(grid, 1601, [&](std::size_t i, std::size_t j) {
    file << fmt::format("{:.17g},{:.17g},{}\n", grid.ratios[i], grid.amplitudes[j], codes[i][j]);
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::string folder = argc > 1 ? argv[1] : ".";
  compare(Model::nonlinear, 1e-9, 400);
  compare(Model::nonlinear, 1e-12, 400);
  compare(Model::linear, 1e-9, 400);
  curves(folder);
  write_cells(folder);
}
