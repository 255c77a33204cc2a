// The cases of the benchmarks, and their times: contenders take turns, and the medians count.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <numerics/motion/overturning.hpp>
#include <string>
#include <vector>

namespace rederive::benchmarks {

/// A case of the benchmarks.
inline numerics::PulseCase asked_with(numerics::Model model, double tolerance = numerics::default_tolerance) {
  numerics::PulseCase asked;
  asked.block = numerics::make_block(0.25, 2.14);
  asked.model = model;
  asked.tolerance = tolerance;
  return asked;
}

/// Returns `count` numbers from `from` to `to`.
inline std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(from + (to - from) * i / (count - 1));
  return all;
}

inline double seconds(const std::function<void()>& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

inline double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// Seconds a round of each, one after the other in every round.
inline std::vector<double> in_turns(const std::vector<std::function<void()>>& contenders, int rounds = 5) {
  std::vector<std::vector<double>> times(contenders.size());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < contenders.size(); ++i) times[i].push_back(seconds(contenders[i]));
  std::vector<double> medians;
  for (const auto& all : times) medians.push_back(median(all));
  return medians;
}

}  // namespace rederive::benchmarks
