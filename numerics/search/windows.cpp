#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numerics/search/edges.hpp>
#include <numerics/search/stations.hpp>
#include <numerics/search/windows.hpp>
#include <stdexcept>
#include <tuple>

namespace rederive::numerics {
namespace {

auto itinerary(const Station& s) {
  return std::tuple(s.outcome.code, s.outcome.side, s.outcome.impacts, s.outcome.lies, s.outcome.rests > 0);
}

/// Returns whether a margin could reach 0 between three of its values, with a reserve: as a parabola would,
/// or, where the itinerary changes and the slope with it, by twice the differences between the values.
bool might_vanish(double a, double b, double c, bool smooth) {
  const double nearest = std::min({std::abs(a), std::abs(b), std::abs(c)});
  const double bend = smooth ? std::abs(a - 2 * b + c) : std::abs(a - b) + std::abs(b - c);
  return nearest < 4 * bend + 1e-7;
}

bool may_hide_a_window(const Station& low, const Station& between, const Station& high,
                       const WindowSearch& search) {
  const bool smooth = itinerary(low) == itinerary(high) && itinerary(low) == itinerary(between);
  const bool one_code = low.code() == high.code() && low.code() == between.code();
  const bool turns = !smooth && high.amplitude - low.amplitude > search.narrowest_turn;
  return !one_code || turns || might_vanish(low.outward, between.outward, high.outward, smooth) ||
         might_vanish(low.returning, between.returning, high.returning, smooth);
}

/// Returns the stations at some amplitudes and between them: gaps are halved, all together, until none may
/// hide a window.
std::vector<Station> scan(const PulseCase& asked, const WindowSearch& search,
                          const std::vector<double>& amplitudes) {
  std::vector<Station> stations = stations_at(asked, amplitudes, search);
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) gaps.push_back({stations[i], stations[i + 1]});
  while (!gaps.empty()) {
    std::erase_if(gaps, [&](const Gap& gap) { return !(gap.width() > search.narrowest); });
    std::vector<Gap> next;
    for (const auto& row : parted(asked, gaps, 2, search)) {
      if (row.size() < 3 || !may_hide_a_window(row[0], row[1], row[2], search)) continue;
      stations.push_back(row[1]);
      next.push_back({row[0], row[1]}), next.push_back({row[1], row[2]});
    }
    gaps = std::move(next);
  }
  std::ranges::sort(stations, {}, &Station::amplitude);
  return stations;
}

/// Adds stations beside each amplitude at which a chain of impacts just comes to rest, if some amplitudes
/// nearby overturn the block. There windows follow each other in a geometric sequence, ever narrower, and so
/// do these stations.
std::vector<Station> beside_chains(const PulseCase& asked, const WindowSearch& search,
                                   const std::vector<Station>& stations) {
  constexpr double nearest = 1e-9, farthest = 1e-4;
  const auto rests = [](const Station& s) { return s.outcome.rests > 0; };
  const auto differ = [&](const Station& a, const Station& b) { return rests(a) != rests(b); };
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) {
    const auto overturns_near = [&](const Station& s) {
      return s.code() != 0 && std::abs(s.amplitude / stations[i].amplitude - 1) < farthest;
    };
    if (differ(stations[i], stations[i + 1]) && std::ranges::any_of(stations, overturns_near))
      gaps.push_back({stations[i], stations[i + 1]});
  }
  if (gaps.empty()) return {};
  for (int k = 0; k < 5; ++k)
    for (std::size_t i = 0; const auto& row : parted(asked, gaps, together, search)) {
      const auto at = std::ranges::adjacent_find(row, differ);
      gaps[i++] = {at[0], at[1]};
    }
  std::vector<double> amplitudes;
  for (const auto& [low, high] : gaps)
    for (double distance = nearest; distance < farthest; distance *= 1.09) {
      const double amplitude = rests(low) ? low.amplitude * (1 + distance) : high.amplitude * (1 - distance);
      if (stations.front().amplitude < amplitude && amplitude < stations.back().amplitude)
        amplitudes.push_back(amplitude);
    }
  return stations_at(asked, amplitudes, search);
}

/// Removes windows that are narrower than an edge is exact, and joins windows that only such a gap separates.
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

/// Returns the first amplitudes, which lie closer together near the smallest.
std::vector<double> first_amplitudes(const PulseCase& asked, const WindowSearch& search) {
  if (!(search.largest > 0 && search.largest <= 1e6))
    throw std::invalid_argument(
        fmt::format("largest amplitude = {} must lie between 0 and 1e6", search.largest));
  if (!(asked.omega_ratio > 0 && std::isfinite(asked.omega_ratio)))
    throw std::invalid_argument(fmt::format("omega_p/p = {} must be positive", asked.omega_ratio));
  const Real exact = start_level(asked.block, asked.model);
  const double rounded = static_cast<double>(exact);
  const double level = rounded < exact ? std::nextafter(rounded, 1e300) : rounded;
  std::vector<double> amplitudes;
  if (!(search.largest >= level)) return amplitudes;
  amplitudes.push_back(level);
  for (int i = 1; i <= search.stations; ++i) {
    const double share = static_cast<double>(i) / search.stations;
    const double amplitude =
        i == search.stations ? search.largest : level + (search.largest - level) * share * share;
    if (amplitude > amplitudes.back()) amplitudes.push_back(amplitude);
  }
  return amplitudes;
}

/// Returns the windows that some stations, in order, show.
std::vector<Window> windows_of(const PulseCase& asked, const WindowSearch& search,
                               const std::vector<Station>& stations) {
  std::vector<Window> windows;
  double from = stations.front().amplitude;
  int code = stations.front().code();
  for (const auto& [before, after] : changes_between(asked, stations, search)) {
    if (code != 0) windows.push_back({from, before.amplitude, code});
    from = after.amplitude, code = after.code();
  }
  if (code != 0) windows.push_back({from, std::nullopt, code});
  return wide_enough(windows, asked.model);
}

bool overturns(const Station& station) { return station.code() != 0; }

void add_stations(std::vector<Station>& stations, const std::vector<Station>& more) {
  stations.insert(stations.end(), more.begin(), more.end());
  std::ranges::stable_sort(stations, {}, &Station::amplitude);
  const auto same = [](const Station& a, const Station& b) { return a.amplitude == b.amplitude; };
  stations.erase(std::unique(stations.begin(), stations.end(), same), stations.end());
}

/// Adds the windows below the first station that overturns the block, down to `lowest`.
void search_below(const PulseCase& asked, const WindowSearch& search, double lowest,
                  std::vector<Station>& stations) {
  constexpr int few = 16;
  const auto first = std::ranges::find_if(stations, overturns);
  const auto has_chain = [](const Station& s) { return s.outcome.impacts > few || s.outcome.rests > 0; };
  if (first != stations.end() && std::any_of(stations.begin(), first + 1, has_chain))
    add_stations(stations, stations_below(asked, search, lowest, *first));
}

PulseCase at_a_glance(PulseCase asked, const WindowSearch& search) {
  if (asked.engine == Engine::taylor) asked.tolerance = std::max(asked.tolerance, search.glance);
  return asked;
}

/// Returns all windows between the first and the last of some amplitudes.
std::vector<Window> all_windows(const PulseCase& asked, const WindowSearch& search,
                                const std::vector<double>& amplitudes) {
  const PulseCase glancing = at_a_glance(asked, search);
  std::vector<Station> stations = scan(glancing, search, amplitudes);
  add_stations(stations, beside_chains(glancing, search, stations));
  search_below(asked, search, amplitudes.front(), stations);
  return windows_of(asked, search, stations);
}

/// Returns the first of these windows: follows each station that overturns the block exactly, until one is in
/// a window.
std::optional<Window> first_window(const PulseCase& asked, const WindowSearch& search,
                                   const std::vector<double>& amplitudes) {
  constexpr std::ptrdiff_t some = 64;
  const PulseCase glancing = at_a_glance(asked, search);
  for (auto from = amplitudes.begin(); from + 1 < amplitudes.end();) {
    const auto to = from + std::min(some, amplitudes.end() - from - 1);
    std::vector<Station> stations = scan(glancing, search, {from, to + 1});
    search_below(asked, search, amplitudes.front(), stations);
    for (auto at = stations.begin(); at < stations.end();) {
      const auto first = std::find_if(at, stations.end(), overturns),
                 end = std::find_if_not(first, stations.end(), overturns);
      if (first == stations.end()) break;
      const auto windows =
          windows_of(asked, search, {first == at ? first : first - 1, end == stations.end() ? end : end + 1});
      if (!windows.empty()) return windows.front();
      at = end;
    }
    from = to;
  }
  return std::nullopt;
}

}  // namespace

std::vector<Window> overturning_windows(const PulseCase& asked, const WindowSearch& search) {
  const std::vector<double> all = first_amplitudes(asked, search);
  if (all.empty()) return {};
  if (!search.least) return all_windows(asked, search, all);
  const std::optional<Window> first = first_window(asked, search, all);
  if (!first) return {};
  return {{first->from, std::nullopt, first->code}};
}

double narrowest_found(const WindowSearch& search) { return search.least ? 1e-9 : search.narrowest_turn; }

std::optional<Window> least_window(const std::vector<Window>& windows) {
  if (windows.empty()) return std::nullopt;
  return windows.front();
}

}  // namespace rederive::numerics
