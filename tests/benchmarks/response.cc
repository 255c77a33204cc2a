// How long one call of the emitted right-hand side takes, beside the same written by hand; and one motion,
// beside GSL's own eighth-order integration of (21a) over the same pulse without events, at the same
// tolerance.
#include <benchmark/benchmark.h>
#include <gsl/gsl_odeiv2.h>

#include <array>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <numerics/search/windows.hpp>

using namespace rederive::numerics;

namespace {

PulseCase asked(Model model) {
  PulseCase result;
  result.block = make_block(0.25, 2.14);
  result.model = model;
  result.omega_ratio = 2;
  return result;
}

int pendulum(double t, const double state[], double rate[], void*) {
  rate[0] = state[1];
  rate[1] = rederive::emitted::angular_acceleration_negative(0.25, 1.0, state[0],
                                                             0.25 * 3 * std::sin(2 * t + 0.35));
  return 0;
}

void peer_gsl_driver(benchmark::State& state) {
  gsl_odeiv2_system system{pendulum, nullptr, 2, nullptr};
  for (auto _ : state) {
    auto* driver = gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 0.1, 1e-13, 1e-13);
    double t = 0, y[2] = {0, 0};
    gsl_odeiv2_driver_apply(driver, &t, 2.96, y);
    benchmark::DoNotOptimize(y[0]);
    gsl_odeiv2_driver_free(driver);
  }
}

/// (21a) with p = 1 as one would write it.
double by_hand(double alpha, double theta, double ground) {
  return std::sin(alpha + theta) - ground * std::cos(alpha + theta);
}

template <class Rate>
void right_hand_side(benchmark::State& state, Rate rate) {
  std::array<double, 1024> theta{};
  for (std::size_t i = 0; i < theta.size(); ++i) theta[i] = -0.001 * static_cast<double>(i);
  for (auto _ : state) {
    double sum = 0;
    for (const double angle : theta) sum += rate(0.25, angle, 0.4);
    benchmark::DoNotOptimize(sum);
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(theta.size()));
}

void outcome(benchmark::State& state, Model model) {
  const PulseCase of = asked(model);
  for (auto _ : state) benchmark::DoNotOptimize(outcome_at(of, 3).code);
}

void windows(benchmark::State& state, Model model) {
  const PulseCase of = asked(model);
  for (auto _ : state) benchmark::DoNotOptimize(overturning_windows(of).size());
}

BENCHMARK_CAPTURE(right_hand_side, emitted, [](double alpha, double theta, double ground) {
  return rederive::emitted::angular_acceleration_negative(alpha, 1.0, theta, ground);
});
BENCHMARK_CAPTURE(right_hand_side, by_hand, by_hand);
BENCHMARK(peer_gsl_driver);
BENCHMARK_CAPTURE(outcome, linear, Model::linear);
BENCHMARK_CAPTURE(outcome, nonlinear, Model::nonlinear);
BENCHMARK_CAPTURE(windows, linear, Model::linear)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(windows, nonlinear, Model::nonlinear)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
