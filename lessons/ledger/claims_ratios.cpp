#include <cmath>
#include <lessons/ledger/claims_motion.hpp>
#include <lessons/ledger/claims_ratios.hpp>

namespace rederive {

namespace {

constexpr double lowest = 3, highest = 12, precision = 1e-7;

PulseCase at(PulseCase asked, double ratio) {
  asked.omega_ratio = ratio;
  return asked;
}

/// The first ratio at which `holds` turns false, walking up, then by halves.
template <class Holds>
std::optional<double> first_end(Holds holds) {
  double low = lowest, high = lowest;
  if (!holds(low)) return std::nullopt;
  do {
    low = high, high *= 1.1;
    if (high > highest) return std::nullopt;
  } while (holds(high));
  while (high - low > precision) {
    const double middle = (low + high) / 2;
    (holds(middle) ? low : high) = middle;
  }
  return low;
}

/// By how much the block overturns after one impact that comes when the pulse is over; -1 if it strikes
/// before or not at all.
double margin_behind_pulse(const PulseCase& asked, double amplitude) {
  const Outcome outcome = outcome_at(asked, amplitude);
  const int impacts_in_pulse = outcome.impacts - (outcome.code == 2 && outcome.side < 0 ? 1 : 0);
  const bool strikes_behind =
      outcome.side < 0 && impacts_in_pulse == 0 && outcome.rests == 0 && outcome.margins.outward <= 0;
  return strikes_behind && !outcome.lies ? static_cast<double>(outcome.margins.returning) : -1;
}

/// The largest of these margins over the amplitude: a row of them, then golden sections.
double best_margin(const PulseCase& asked) {
  const double first = static_cast<double>(start_level(asked.block, asked.model)) * 1.01, factor = 1.03;
  double best = first;
  for (double a = first; a < 25; a *= factor)
    if (margin_behind_pulse(asked, a) > margin_behind_pulse(asked, best)) best = a;
  double low = best / factor, high = best * factor;
  for (int i = 0; i < 25; ++i) {
    const double left = std::lerp(low, high, 0.382), right = std::lerp(low, high, 0.618);
    (margin_behind_pulse(asked, left) > margin_behind_pulse(asked, right) ? high : low) =
        margin_behind_pulse(asked, left) > margin_behind_pulse(asked, right) ? right : left;
  }
  return margin_behind_pulse(asked, (low + high) / 2);
}

}  // namespace

std::optional<double> ratio_of_handover(
    const PulseCase& asked, const std::function<std::optional<double>(const PulseCase&)>& threshold) {
  return first_end([&](double ratio) {
    const PulseCase here = at(asked, ratio);
    const auto amplitude = threshold(here);
    return amplitude &&
           respond(here.block, here.model, ground_of(here, *amplitude), here.initial).impacts > 0;
  });
}

std::optional<double> ratio_of_end(const PulseCase& asked) {
  return first_end([&](double ratio) { return best_margin(at(asked, ratio)) > 0; });
}

}  // namespace rederive
