// The batched kernels against outcome_at, which integrates by GSL, and against each other.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numerics/motion/batch.hpp>
#include <random>
#include <stdexcept>
#include <tuple>

using namespace rederive::numerics;

namespace {

PulseCase nonlinear(double alpha, double restitution) {
  PulseCase asked;
  asked.block = make_block(alpha, 2.14, restitution);
  asked.model = Model::nonlinear;
  return asked;
}

std::vector<double> amplitudes_above(const PulseCase& asked, std::mt19937& random, int count) {
  std::uniform_real_distribution<double> share(0, 1);
  const auto level = static_cast<double>(start_level(asked.block, asked.model));
  std::vector<double> amplitudes;
  for (int i = 0; i < count; ++i)
    amplitudes.push_back(level * (1 + 1e-12 + 14 * share(random) * share(random)));
  return amplitudes;
}

/// Whether the code that outcome_at gives is the same all around: 1e-9 away from any boundary.
bool is_certain(const PulseCase& asked, double amplitude) {
  const int code = outcome_at(asked, amplitude).code;
  return outcome_at(asked, amplitude * (1 - 1e-9)).code == code &&
         outcome_at(asked, amplitude * (1 + 1e-9)).code == code;
}

/// Cells that differ where they may not.
int wrong_cells(const PulseCase& asked, const std::vector<double>& amplitudes) {
  int wrong = 0;
  const std::vector<int> codes = PulseBatch(asked, amplitudes).codes({asked.omega_ratio}).front();
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    const bool differs =
        codes[i] != outcome_at(asked, amplitudes[i]).code && is_certain(asked, amplitudes[i]);
    CHECK_MESSAGE(!differs, "omega_p/p = ", asked.omega_ratio, ", amplitude ", amplitudes[i], ", alpha ",
                  asked.block.alpha);
    wrong += differs ? 1 : 0;
  }
  return wrong;
}

}  // namespace

TEST_CASE("blocks and pulses at random come out as by GSL") {
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> share(0, 1);
  int wrong = 0;
  for (int i = 0; i < 150; ++i) {
    PulseCase asked = nonlinear(0.05 + 1.45 * share(random), 0.3 + 0.7 * share(random));
    asked.pulse = i % 2 == 0 ? Pulse::sine : Pulse::cosine;
    asked.omega_ratio = i % 3 == 0 ? std::pow(10, -1.5 * share(random)) : 0.2 + 9.8 * share(random);
    if (i % 5 == 0) asked.model = Model::linear;
    if (i % 4 == 1) asked.initial = {1.6L * share(random) - 0.8L, 2 * share(random) - 1.0L};
    wrong += wrong_cells(asked, amplitudes_above(asked, random, 40));
  }
  CHECK(wrong == 0);
}

TEST_CASE("at the edges of the range, too") {
  std::mt19937 random(4712);
  for (const double restitution : {1.0, 0.02})
    for (const double alpha : {1e-8, 0.25, 1.5}) {
      PulseCase asked = nonlinear(alpha, restitution);
      for (const double ratio : {0.03, 2.0, 50.0}) {
        asked.omega_ratio = ratio;
        CHECK(wrong_cells(asked, amplitudes_above(asked, random, 20)) == 0);
      }
    }
}

TEST_CASE("every kernel gives the same cells, one frequency at a time or all together") {
  for (const Model model : {Model::nonlinear, Model::linear}) {
    PulseCase asked = nonlinear(0.25, 0.9);
    asked.model = model;
    std::vector<double> amplitudes;
    for (int i = 0; i < 203; ++i) amplitudes.push_back(0.9 + 0.05 * i);
    const std::vector<double> ratios{0.2, 1.0, 2.5, 4.0, 7.0};
    const auto first = PulseBatch(asked, amplitudes, batch_kernels().front()).codes(ratios);
    for (const BatchKernel& kernel : batch_kernels()) {
      CAPTURE(kernel.name);
      const PulseBatch batch(asked, amplitudes, kernel);
      CHECK(batch.codes(ratios) == first);
      for (std::size_t i = 0; i < ratios.size(); ++i) CHECK(batch.codes({ratios[i]}).front() == first[i]);
    }
  }
}

TEST_CASE("a code that is certain before the pulse is over is that of the whole motion") {
  std::mt19937 random(4714);
  std::uniform_real_distribution<double> share(0, 1);
  int wrong = 0;
  for (int i = 0; i < 2000; ++i) {
    PulseCase asked = nonlinear(0.02 + 1.5 * share(random), i % 7 == 0 ? 1 : 0.3 + 0.7 * share(random));
    if (i % 3 == 0) asked.model = Model::linear;
    if (i % 2 == 0) asked.pulse = Pulse::cosine;
    if (i % 5 > 1) asked.initial = {1.6L * share(random) - 0.8L, 2 * share(random) - 1.0L};
    std::vector<double> ratios;
    for (int k = 0; k < 10; ++k) ratios.push_back(10 * std::pow(10, -2.5 * share(random)));
    const std::vector<double> amplitudes = amplitudes_above(asked, random, 50);
    const PulseBatch batch(asked, amplitudes);
    const auto codes = batch.codes(ratios);
    const auto outcomes = batch.outcomes(ratios);
    for (std::size_t column = 0; column < ratios.size(); ++column)
      for (std::size_t row = 0; row < amplitudes.size(); ++row) {
        if (codes[column][row] == outcomes[column][row].code) continue;
        asked.omega_ratio = ratios[column];
        wrong += is_certain(asked, amplitudes[row]) ? 1 : 0;
      }
  }
  CHECK(wrong == 0);
}

TEST_CASE("every kernel gives the same motions, and the same bits in whatever lane") {
  for (const bool is_linear : {false, true}) {
    const double alpha = 0.25, ground = -std::tan(alpha);
    std::vector<KernelStart<double>> starts;
    for (int i = 0; i < 74; ++i) {
      const double omega = 1 + 0.1 * (i % 37), amplitude = (i < 37 ? 1.5 : 3) * alpha;
      const double quadrature = -std::sqrt(amplitude * amplitude - ground * ground),
                   psi = std::asin(-ground / amplitude);
      starts.push_back({.rate = omega,
                        .ground = ground,
                        .quadrature = quadrature,
                        .push = (std::numbers::pi - 2 * psi) / omega,
                        .left = (2 * std::numbers::pi - psi) / omega,
                        .fading = std::numbers::pi / omega,
                        .slow = 1e-4});
    }
    std::vector<KernelEnd<double>> first;
    int with_impacts = 0;
    for (const BatchKernel& kernel : batch_kernels()) {
      CAPTURE(kernel.name);
      std::vector<KernelEnd<double>> ends(starts.size());
      kernel.run({is_linear, alpha, 0.9, 1e-12}, starts.data(), ends.data(), static_cast<int>(starts.size()));
      if (first.empty()) first = ends;
      for (std::size_t i = 0; i < starts.size(); ++i) {
        KernelEnd<double> alone{};
        kernel.run({is_linear, alpha, 0.9, 1e-12}, &starts[i], &alone, 1);
        CHECK(ends[i].theta == alone.theta);
        CHECK(ends[i].thetadot == alone.thetadot);
        with_impacts += ends[i].impacts > 0 && ends[i].theta > 0 ? 1 : 0;
        CHECK(ends[i].how == first[i].how);
        CHECK(ends[i].impacts == first[i].impacts);
        CHECK(std::abs(ends[i].theta - first[i].theta) < 1e-12);
        CHECK(std::abs(ends[i].thetadot - first[i].thetadot) < 1e-12);
      }
    }
    CHECK(with_impacts >= 20);  // and went on after them
    std::map<KernelEnd<double>::How, int> early;
    std::vector<KernelEnd<double>> ends(starts.size());
    batch_kernels().back().run({is_linear, alpha, 0.9, 1e-12, true}, starts.data(), ends.data(),
                               static_cast<int>(starts.size()));
    for (const KernelEnd<double>& end : ends) early[end.how] += end.left > 0 ? 1 : 0;
    for (const auto how :
         {KernelEnd<double>::How::overturns, KernelEnd<double>::How::returns, KernelEnd<double>::How::safe})
      CHECK(early[how] > 0);
  }
}

TEST_CASE("the margins of the kernels are those of outcome_at") {
  std::mt19937 random(4713);
  for (const Model model : {Model::linear, Model::nonlinear}) {
    PulseCase asked = nonlinear(0.25, 0.9);
    asked.model = model, asked.omega_ratio = 2.3;
    const auto amplitudes = amplitudes_above(asked, random, 50);
    const auto outcomes = outcomes_at(asked, amplitudes);
    for (std::size_t i = 0; i < amplitudes.size(); ++i) {
      const Outcome outcome = outcome_at(asked, amplitudes[i]);
      if (outcome.lies) continue;  // by then the margins are those of wherever a step ended
      const Margins exact = outcome.margins, found = outcomes[i].margins;
      CHECK(std::abs(found.outward - exact.outward) < 1e-10L * (1 + std::abs(exact.outward)));
      CHECK(std::abs(found.returning - exact.returning) < 1e-10L * (1 + std::abs(exact.returning)));
    }
  }
}

TEST_CASE("what the kernel leaves unresolved is followed, and what does not move is safe") {
  PulseCase asked = nonlinear(0.25, 0.6);
  asked.omega_ratio = 0.5;
  const auto level = static_cast<double>(start_level(asked.block, asked.model));
  const std::vector<double> amplitudes{0, level / 2, level, level * (1 + 1e-9), 1.03, 1.1};
  const std::vector<int> codes = PulseBatch(asked, amplitudes).codes({asked.omega_ratio}).front();
  bool rests = false;
  for (std::size_t i = 0; i < amplitudes.size(); ++i) {
    const Outcome outcome = outcome_at(asked, amplitudes[i]);
    CHECK(codes[i] == outcome.code);
    const Outcome found = outcomes_at(asked, {amplitudes[i]}).front();
    CHECK(std::tuple(found.code, found.side, found.impacts, found.rests) ==
          std::tuple(outcome.code, outcome.side, outcome.impacts, outcome.rests));
    rests = rests || outcome.rests > 0;
  }
  CHECK(rests);
  asked.initial = {0.1L, 0};
  CHECK_THROWS_AS(PulseBatch(asked, {0.5}), std::invalid_argument);
}

TEST_CASE("several threads share half a million amplitudes to the last one") {
  std::vector<double> amplitudes(500'000, 0);
  amplitudes.back() = 8;
  const PulseCase asked = nonlinear(0.25, 0.9);
  const std::vector<Outcome> outcomes = outcomes_at(asked, amplitudes, 2);
  CHECK(std::ranges::count(outcomes, 0, &Outcome::code) == std::ssize(amplitudes) - 1);
  CHECK(outcomes.back().code == outcome_at(asked, 8).code);
}
