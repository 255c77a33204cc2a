#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <numerics/windows.hpp>
#include <stdexcept>
#include <tuple>

namespace rederive::inline numeric {
namespace {

/// The outcome at one amplitude, the margins squeezed into (-1, 1) so that their steep parts do not hide the
/// rest.
struct Station {
  double amplitude = 0;
  Outcome outcome;
  double outward = -1, returning = -1;
};

double squeezed(Real margin) { return static_cast<double>(margin / (1 + std::abs(margin))); }

auto itinerary(const Station& s) {
  return std::tuple(s.outcome.code, s.outcome.side, s.outcome.impacts, s.outcome.lies, s.outcome.rests > 0);
}

class Scan {
 public:
  Scan(const PulseCase& asked, const WindowSearch& search) : asked_(asked), search_(search) {}

  std::vector<Station> stations() {
    const Real exact = start_level(asked_.block, asked_.model);
    const double rounded = static_cast<double>(exact);
    const double level = rounded < exact ? std::nextafter(rounded, 1e300) : rounded;
    std::vector<Station> all;
    if (!(search_.largest >= level)) return all;
    all.push_back(at(level));
    for (int i = 1; i <= search_.stations; ++i) {
      const double share = static_cast<double>(i) / search_.stations;
      const double amplitude =
          i == search_.stations ? search_.largest : level + (search_.largest - level) * share * share;
      const Station next = at(amplitude);
      if (next.amplitude > all.back().amplitude) refine(all, all.back(), next, 0);
    }
    return all;
  }

 private:
  Station at(double amplitude) const {
    Station station{amplitude, outcome_at(asked_, amplitude)};
    station.outward = squeezed(station.outcome.margins.outward);
    station.returning = squeezed(station.outcome.margins.returning);
    return station;
  }

  /// Whether a margin, from its three values and with room to spare, could reach zero between them: as a
  /// parabola would, or, where the itinerary changes and with it the slope, as twice the differences found.
  static bool might_vanish(double a, double b, double c, bool smooth) {
    const double nearest = std::min({std::abs(a), std::abs(b), std::abs(c)});
    const double bend = smooth ? std::abs(a - 2 * b + c) : std::abs(a - b) + std::abs(b - c);
    return nearest < 4 * bend + 1e-7;
  }

  /// Appends the stations in (low, high].
  void refine(std::vector<Station>& all, const Station& low, const Station& high, int depth) {
    const double width = high.amplitude - low.amplitude,
                 middle = std::midpoint(low.amplitude, high.amplitude);
    if (width > search_.narrowest && depth < 48) {
      const Station between = at(middle);
      const bool smooth = itinerary(low) == itinerary(high) && itinerary(low) == itinerary(between);
      const bool one_code = low.outcome.code == high.outcome.code && low.outcome.code == between.outcome.code;
      const bool turns = !smooth && width > search_.narrowest_turn;
      if (!one_code || turns || might_vanish(low.outward, between.outward, high.outward, smooth) ||
          might_vanish(low.returning, between.returning, high.returning, smooth)) {
        refine(all, low, between, depth + 1);
        refine(all, between, high, depth + 1);
        return;
      }
    }
    all.push_back(high);
  }

  PulseCase asked_;
  WindowSearch search_;
};

/// Appends the changes of code in (low, high]: last amplitude before, first with the new code, and that code.
struct NewCode {
  double last_before, first_after;
  int code;
};

void find_changes(const PulseCase& asked, double low, int code, double high, int code_high,
                  std::vector<NewCode>& changes) {
  for (int guard = 0; code != code_high && guard < 64; ++guard) {
    const Change edge = edge_of_code(asked, code, low, high);
    const int next = outcome_at(asked, edge.outside).code;
    changes.push_back({edge.inside, edge.outside, next});
    low = edge.outside;
    code = next;
  }
  if (code != code_high) changes.push_back({low, high, code_high});
}

/// Drops what is narrower than an edge is exact, and joins what only that had parted.
std::vector<Window> wide_enough(const std::vector<Window>& all, Model model) {
  const double narrowest = exactness_of_edges(model);
  const auto beside = [&](double low, double high) { return !(high - low > narrowest * high); };
  std::vector<Window> kept;
  for (const Window& window : all) {
    if (window.to && beside(window.from, *window.to)) continue;
    const bool same =
        !kept.empty() && kept.back().code == window.code && beside(*kept.back().to, window.from);
    if (same)
      kept.back().to = window.to;
    else
      kept.push_back(window);
  }
  return kept;
}

}  // namespace

Change edge_of_code(const PulseCase& asked, int code, double inside, double outside) {
  return change_between([&](double amplitude) { return outcome_at(asked, amplitude).code == code; }, inside,
                        outside);
}

std::vector<Window> overturning_windows(const PulseCase& asked, const WindowSearch& search) {
  if (!(search.largest > 0 && search.largest <= 1e6))
    throw std::invalid_argument(
        fmt::format("largest amplitude = {} must lie between 0 and 1e6", search.largest));
  if (!(asked.omega_ratio > 0 && std::isfinite(asked.omega_ratio)))
    throw std::invalid_argument(fmt::format("omega_p/p = {} must be positive", asked.omega_ratio));
  const auto stations = Scan(asked, search).stations();
  std::vector<Window> windows;
  if (stations.empty()) return windows;
  std::vector<NewCode> changes;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i)
    find_changes(asked, stations[i].amplitude, stations[i].outcome.code, stations[i + 1].amplitude,
                 stations[i + 1].outcome.code, changes);
  double from = stations.front().amplitude;
  int code = stations.front().outcome.code;
  for (const NewCode& change : changes) {
    if (code != 0) windows.push_back({from, change.last_before, code});
    from = change.first_after, code = change.code;
  }
  if (code != 0) windows.push_back({from, std::nullopt, code});
  return wide_enough(windows, asked.model);
}

std::optional<Window> least_window(const std::vector<Window>& windows) {
  if (windows.empty()) return std::nullopt;
  return windows.front();
}

}  // namespace rederive::inline numeric
