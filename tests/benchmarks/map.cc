// The nonlinear map against plain GSL on one thread: build/tests/benchmark_map [points a side]. The peer
// integrates (21a,b) by the eighth-order method rk8pd, finds an impact by Newton's iteration on the step that
// crossed, taken again, and asks energy when the pulse is over, as the kernels do; a slow block it takes for
// safe. Peer and kernels take turns, some columns at a time, and their codes are compared; the medians of
// the runs count.
#include <fmt/format.h>
#include <gsl/gsl_odeiv2.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <emitted/rocking_block.hpp>
#include <numbers>
#include <numerics/batch.hpp>

using namespace rederive;

namespace {

struct Motion {
  double alpha, amplitude, omega, psi;
  int side;
};

int rates(double t, const double y[], double rate[], void* parameters) {
  const Motion& m = *static_cast<const Motion*>(parameters);
  const double ground = emitted::ground_of_sine_pulse(m.amplitude, m.omega, m.psi, t);
  rate[0] = y[1];
  rate[1] = m.side < 0 ? emitted::angular_acceleration_negative(m.alpha, 1.0, y[0], ground)
                       : emitted::angular_acceleration_positive(m.alpha, 1.0, y[0], ground);
  return 0;
}

class Peer {
 public:
  Peer(const Block& block, double tolerance)
      : block_(block),
        step_(gsl_odeiv2_step_alloc(gsl_odeiv2_step_rk8pd, 2)),
        control_(gsl_odeiv2_control_y_new(block.alpha * tolerance, tolerance)),
        evolve_(gsl_odeiv2_evolve_alloc(2)) {}
  Peer(const Peer&) = delete;
  ~Peer() { gsl_odeiv2_evolve_free(evolve_), gsl_odeiv2_control_free(control_), gsl_odeiv2_step_free(step_); }

  int code(double omega, double amplitude) {
    const double level = emitted::ground_that_starts(block_.alpha), alpha = block_.alpha;
    if (alpha * amplitude <= level) return 0;
    Motion motion{alpha, alpha * amplitude, omega, emitted::phase_of_sine_pulse(level / (alpha * amplitude)),
                  -1};
    gsl_odeiv2_system system{rates, nullptr, 2, &motion};
    const double end = emitted::end_of_sine_pulse(omega, motion.psi);
    double t = 0, h = 0.1, y[2] = {0, 0};
    int impacts = 0;
    restart();
    while (t < end) {
      const double before[3] = {t, y[0], y[1]};
      gsl_odeiv2_evolve_apply(evolve_, control_, step_, &system, &t, end, &h, y);
      if (motion.side * y[0] >= std::numbers::pi / 2) return motion.side * (impacts + 1);
      if (motion.side * y[0] > 0) continue;
      t = before[0] + impact(system, before, t - before[0], y);
      if (std::fabs(y[1]) < 1e-3 * alpha) return 0;
      y[0] = 0, y[1] *= block_.restitution, motion.side = -motion.side, ++impacts;
      restart();
    }
    const double angle = motion.side * y[0] / alpha, velocity = motion.side * y[1] / alpha;
    if (velocity > emitted::critical_velocity_positive(alpha, angle)) return motion.side * (impacts + 1);
    const double square = emitted::impact_velocity_squared_positive(alpha, angle, velocity);
    const bool returns = block_.restitution * std::sqrt(std::max(0.0, square)) >
                         emitted::critical_velocity_positive(alpha, 0.0);
    return returns ? -motion.side * (impacts + 2) : 0;
  }

 private:
  void restart() { gsl_odeiv2_evolve_reset(evolve_), gsl_odeiv2_step_reset(step_); }

  double impact(const gsl_odeiv2_system& system, const double before[], double length, double y[]) {
    double error[2], moved = 1;
    for (int i = 0; i < 20 && std::fabs(moved) > 1e-9 * length; ++i) {
      moved = -y[0] / y[1];
      length += moved;
      y[0] = before[1], y[1] = before[2];
      gsl_odeiv2_step_reset(step_);
      gsl_odeiv2_step_apply(step_, before[0], length, y, error, nullptr, nullptr, &system);
    }
    return length;
  }

  Block block_;
  gsl_odeiv2_step* step_;
  gsl_odeiv2_control* control_;
  gsl_odeiv2_evolve* evolve_;
};

double seconds(const auto& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2),
                   values.end());
  return values[values.size() / 2];
}

void compare(int points, double tolerance) {
  PulseCase asked;
  asked.block = make_block(0.25, 2.14);
  asked.model = Model::nonlinear;
  asked.tolerance = tolerance;
  std::vector<double> amplitudes;
  for (int i = 0; i < points; ++i) amplitudes.push_back(1 + 11.0 * i / (points - 1));
  Peer peer(asked.block, tolerance);
  std::vector<PulseBatch> batches;
  for (const BatchKernel& kernel : batch_kernels()) batches.emplace_back(asked, amplitudes, kernel);
  std::vector<std::vector<double>> times(batches.size() + 1);
  std::vector<long> differing(batches.size(), 0);
  constexpr int runs = 5;
  for (int run = 0; run < runs; ++run) {
    std::vector<double> sum(times.size(), 0);
    const int together = 1 + 800 / points;
    for (int first = 0; first < points; first += together) {
      std::vector<double> ratios;
      for (int i = first; i < std::min(first + together, points); ++i)
        ratios.push_back(0.2 + 9.8 * i / (points - 1));
      std::vector<std::vector<int>> by_peer(ratios.size()), codes;
      sum[0] += seconds([&] {
        for (std::size_t i = 0; i < ratios.size(); ++i)
          for (const double amplitude : amplitudes) by_peer[i].push_back(peer.code(ratios[i], amplitude));
      });
      for (std::size_t k = 0; k < batches.size(); ++k) {
        sum[k + 1] += seconds([&] { codes = batches[k].codes(ratios); });
        for (std::size_t i = 0; run == 0 && i < codes.size(); ++i)
          for (std::size_t j = 0; j < codes[i].size(); ++j)
            differing[k] += codes[i][j] != by_peer[i][j] ? 1 : 0;
      }
    }
    for (std::size_t k = 0; k < times.size(); ++k) times[k].push_back(sum[k]);
  }
  const double cells = static_cast<double>(points) * points, base = median(times[0]);
  fmt::print("{} x {} cells, tolerance {:g}, one thread, medians of {} runs in turns\n", points, points,
             tolerance, runs);
  fmt::print("  {:10} {:>10.0f} a second\n", "GSL rk8pd", cells / base);
  for (std::size_t k = 0; k < batches.size(); ++k)
    fmt::print("  {:10} {:>10.0f} a second, {:5.1f} x GSL; {} cells differ from the peer's\n",
               batch_kernels()[k].name, cells / median(times[k + 1]), base / median(times[k + 1]),
               differing[k]);
}

}  // namespace

int main(int argc, char** argv) {
  const int points = argc > 1 ? std::atoi(argv[1]) : 200;
  for (const double tolerance : {1e-9, 1e-12}) compare(std::clamp(points, 2, 4000), tolerance);
}
