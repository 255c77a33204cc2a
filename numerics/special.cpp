#include <numerics/special.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace rederive::inline numeric {
namespace {

constexpr double lowest_ratio = 1, highest_ratio = 60, largest_amplitude = 200;

PulseCase at_ratio(PulseCase asked, double omega_ratio) {
  asked.omega_ratio = omega_ratio;
  asked.pulse = Pulse::sine;
  asked.initial = {};
  return asked;
}

/// How far the motion is above the threshold after exactly one impact; continuous where that impact passes
/// the end of the pulse.
Real margin_after_one_impact(const PulseCase& asked, double amplitude) {
  const Outcome outcome = outcome_at(asked, amplitude);
  if (outcome.rests != 0 || outcome.lies || outcome.side == 0) return -1;
  const int during = outcome.code == 2 && outcome.side == -1 ? 0 : outcome.impacts;
  if (outcome.side == -1 && during == 0) return outcome.margins.outward > 0 ? -1 : outcome.margins.returning;
  if (outcome.side == 1 && during == 1) return outcome.margins.outward;
  return -1;
}

bool impact_in_pulse(const PulseCase& asked, double amplitude) {
  const Outcome outcome = outcome_at(asked, amplitude);
  return outcome.rests != 0 || outcome.side >= 0 || outcome.impacts > (outcome.code == 2 ? 1 : 0);
}

/// The least amplitude without an impact before the pulse ends.
double amplitude_of_impact_at_end(const PulseCase& asked) {
  double with = static_cast<double>(start_level(asked.block, asked.model)) * (1 + 1e-6), without = with;
  while (without < largest_amplitude && impact_in_pulse(asked, without))
    with = without, without = 1 + 1.2 * (without - 1) + 1e-3;
  for (double middle = std::midpoint(with, without); with < middle && middle < without;
       middle = std::midpoint(with, without))
    (impact_in_pulse(asked, middle) ? with : without) = middle;
  return without;
}

/// The amplitude of the largest margin: a coarse search, golden sections, then where the slope by five points
/// is 0.
double best_amplitude(const PulseCase& asked) {
  const auto margin = [&](double amplitude) { return margin_after_one_impact(asked, amplitude); };
  const double least = static_cast<double>(start_level(asked.block, asked.model)) * (1 + 1e-6);
  double best = least, factor = 1.01;
  for (double a = least; a < largest_amplitude; a *= factor)
    if (margin(a) > margin(best)) best = a;
  double low = std::max(least, best / factor), high = best * factor;
  while (high - low > 1e-4 * best) {
    const double left = std::lerp(low, high, 0.382), right = std::lerp(low, high, 0.618);
    (margin(left) > margin(right) ? high : low) = margin(left) > margin(right) ? right : left;
  }
  const double step = 1e-3 * best;
  const auto slope = [&](double a) {
    return 8 * (margin(a + step) - margin(a - step)) - (margin(a + 2 * step) - margin(a - 2 * step));
  };
  low -= step, high += step;
  if (!(slope(low) > 0 && slope(high) < 0)) return std::midpoint(low, high);
  for (double a = std::midpoint(low, high); low < a && a < high; a = std::midpoint(low, high))
    (slope(a) > 0 ? low : high) = a;
  return low;
}

/// The first omega_p/p at which `positive` turns false, walking up from the lowest.
template <class F>
std::optional<double> first_end(F&& positive) {
  double low = lowest_ratio, high = lowest_ratio;
  if (!positive(low)) return std::nullopt;
  do {
    low = high, high *= 1.08;
    if (high > highest_ratio) return std::nullopt;
  } while (positive(high));
  for (double middle = std::midpoint(low, high); low < middle && middle < high;
       middle = std::midpoint(low, high))
    (positive(middle) ? low : high) = middle;
  return low;
}

}  // namespace

std::optional<SpecialPoint> handover(const PulseCase& asked) {
  const auto overturns = [&](double ratio) {
    const PulseCase here = at_ratio(asked, ratio);
    return margin_after_one_impact(here, amplitude_of_impact_at_end(here)) > 0;
  };
  const auto ratio = first_end(overturns);
  if (!ratio) return std::nullopt;
  return SpecialPoint{*ratio, amplitude_of_impact_at_end(at_ratio(asked, *ratio))};
}

std::optional<SpecialPoint> end_of_mode_2(const PulseCase& asked) {
  const auto overturns = [&](double ratio) {
    const PulseCase here = at_ratio(asked, ratio);
    return margin_after_one_impact(here, best_amplitude(here)) > 0;
  };
  const auto ratio = first_end(overturns);
  if (!ratio) return std::nullopt;
  return SpecialPoint{*ratio, best_amplitude(at_ratio(asked, *ratio))};
}

}  // namespace rederive::numeric
