#include <algorithm>
#include <functional>
#include <lessons/rocking_block/claims_ratios.hpp>
#include <numerics/search/roots.hpp>

namespace rederive::rocking_block {

using namespace numerics;

namespace {

constexpr double lowest_ratio = 1, highest_ratio = 60, largest_amplitude = 200;

PulseCase at_ratio(PulseCase asked, double omega_ratio) {
  asked.omega_ratio = omega_ratio;
  asked.pulse = Pulse::sine;
  asked.initial = {};
  return asked;
}

double least_amplitude(const PulseCase& asked) {
  return static_cast<double>(start_level(asked.block, asked.model)) * (1 + 1e-6);
}

/// Returns how far the motion is above the threshold after exactly one impact, and -1 after another number of
/// impacts. It is continuous where that impact passes the end of the pulse.
double margin_after_one_impact(const PulseCase& asked, double amplitude) {
  const Outcome outcome = outcome_at(asked, amplitude);
  if (outcome.rests != 0 || outcome.lies || outcome.side == 0) return -1;
  const int during = outcome.code == 2 && outcome.side == -1 ? 0 : outcome.impacts;
  if (outcome.side == -1 && during == 0)
    return outcome.margins.outward > 0 ? -1 : static_cast<double>(outcome.margins.returning);
  return outcome.side == 1 && during == 1 ? static_cast<double>(outcome.margins.outward) : -1;
}

bool impact_in_pulse(const PulseCase& asked, double amplitude) {
  const Outcome outcome = outcome_at(asked, amplitude);
  return outcome.rests != 0 || outcome.side >= 0 || outcome.impacts > (outcome.code == 2 ? 1 : 0);
}

/// Returns the least amplitude without an impact before the pulse ends.
double amplitude_of_impact_at_end(const PulseCase& asked) {
  const auto with_impact = [&](double amplitude) { return impact_in_pulse(asked, amplitude); };
  double with = least_amplitude(asked), without = with;
  while (without < largest_amplitude && with_impact(without))
    with = without, without = 1 + 1.2 * (without - 1) + 1e-3;
  return with < without ? change_between(with_impact, with, without).outside : without;
}

/// Returns the amplitude with the largest margin: the best one of a grid, refined between its neighbours.
double best_amplitude(const PulseCase& asked) {
  constexpr double factor = 1.02;
  const auto shortfall = [&](double amplitude) { return -margin_after_one_impact(asked, amplitude); };
  const double least = least_amplitude(asked);
  double best = least, at_best = shortfall(least);
  for (double amplitude = least; amplitude < largest_amplitude; amplitude *= factor)
    if (const double here = shortfall(amplitude); here < at_best) best = amplitude, at_best = here;
  return least_between(shortfall, std::max(least, best / factor), best * factor);
}

/// Returns the least omega_p/p at which the margin at `amplitude` falls to 0.
std::optional<SpecialPoint> first_end(const PulseCase& asked,
                                      const std::function<double(const PulseCase&)>& amplitude) {
  const auto margin = [&](double ratio) {
    const PulseCase here = at_ratio(asked, ratio);
    return margin_after_one_impact(here, amplitude(here));
  };
  double low = lowest_ratio, high = lowest_ratio;
  if (!(margin(low) > 0)) return std::nullopt;
  do {
    low = high, high *= 1.08;
    if (high > highest_ratio) return std::nullopt;
  } while (margin(high) > 0);
  const double ratio = root_between(margin, low, high);
  return SpecialPoint{ratio, amplitude(at_ratio(asked, ratio))};
}

}  // namespace

std::optional<SpecialPoint> handover(const PulseCase& asked) {
  return first_end(asked, amplitude_of_impact_at_end);
}

std::optional<SpecialPoint> end_of_mode_2(const PulseCase& asked) { return first_end(asked, best_amplitude); }

}  // namespace rederive::rocking_block
