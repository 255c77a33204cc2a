// How long one motion takes, as a ratio to a named peer: GSL's own eighth-order integration of (21a) over the
// same pulse without events, at the same tolerance.
#include <benchmark/benchmark.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <emitted/rocking_block.hpp>
#include <numerics/windows.hpp>

using namespace rederive;

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
  rate[1] = emitted::angular_acceleration_negative(0.25, 1.0, state[0], 0.25 * 3 * std::sin(2 * t + 0.35));
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

void outcome(benchmark::State& state, Model model) {
  const PulseCase of = asked(model);
  for (auto _ : state) benchmark::DoNotOptimize(outcome_at(of, 3).code);
}

void windows(benchmark::State& state, Model model) {
  const PulseCase of = asked(model);
  for (auto _ : state) benchmark::DoNotOptimize(overturning_windows(of).size());
}

BENCHMARK(peer_gsl_driver);
BENCHMARK_CAPTURE(outcome, linear, Model::linear);
BENCHMARK_CAPTURE(outcome, nonlinear, Model::nonlinear);
BENCHMARK_CAPTURE(windows, linear, Model::linear)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(windows, nonlinear, Model::nonlinear)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
