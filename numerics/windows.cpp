#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numerics/batch.hpp>
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
  int code() const { return outcome.code; }
};

double squeezed(Real margin) { return static_cast<double>(margin / (1 + std::abs(margin))); }

auto itinerary(const Station& s) {
  return std::tuple(s.outcome.code, s.outcome.side, s.outcome.impacts, s.outcome.lies, s.outcome.rests > 0);
}

using Stop = const std::atomic<bool>*;

/// All at once; where they might be stopped, some at a time.
std::vector<Station> stations_at(const PulseCase& asked, const std::vector<double>& amplitudes,
                                 Stop stop = nullptr, int threads = 1) {
  const auto end = amplitudes.end();
  const std::ptrdiff_t some = stop == nullptr ? end - amplitudes.begin() : 64 * threads;
  std::vector<Station> stations;
  for (auto from = amplitudes.begin(); from != end;) {
    if (stop != nullptr && *stop) throw Stopped();
    const auto to = from + std::min(some, end - from);
    for (const Outcome& outcome : outcomes_at(asked, {from, to}, threads))
      stations.push_back({amplitudes[stations.size()], outcome, squeezed(outcome.margins.outward),
                          squeezed(outcome.margins.returning)});
    from = to;
  }
  return stations;
}

/// Between two stations.
struct Gap {
  Station low, high;
  double width() const { return high.amplitude - low.amplitude; }
};

/// Parts all gaps together, each into `parts`: the stations of each, its ends among them.
std::vector<std::vector<Station>> parted(const PulseCase& asked, const std::vector<Gap>& gaps, int parts,
                                         Stop stop = nullptr, int threads = 1) {
  std::vector<double> amplitudes;
  for (const auto& [low, high] : gaps)
    for (int i = 1; i < parts; ++i)
      amplitudes.push_back(std::lerp(low.amplitude, high.amplitude, static_cast<double>(i) / parts));
  const std::vector<Station> found = stations_at(asked, amplitudes, stop, threads);
  std::vector<std::vector<Station>> rows;
  auto next = found.begin();
  for (const auto& [low, high] : gaps) {
    std::vector<Station>& row = rows.emplace_back(1, low);
    for (int i = 1; i < parts; ++i, ++next)
      if (row.back().amplitude < next->amplitude && next->amplitude < high.amplitude) row.push_back(*next);
    row.push_back(high);
  }
  return rows;
}

/// Whether a margin, from its three values and with room to spare, could reach zero between them: as a
/// parabola would, or, where the itinerary changes and with it the slope, as twice the differences found.
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

/// The stations at some amplitudes, and between them: gaps are halved, all together, until none may hide a
/// window.
std::vector<Station> scan(const PulseCase& asked, const WindowSearch& search,
                          const std::vector<double>& amplitudes) {
  std::vector<Station> stations = stations_at(asked, amplitudes, search.stop, search.threads);
  std::vector<Gap> gaps;
  for (std::size_t i = 0; i + 1 < stations.size(); ++i) gaps.push_back({stations[i], stations[i + 1]});
  while (!gaps.empty()) {
    std::erase_if(gaps, [&](const Gap& gap) { return !(gap.width() > search.narrowest); });
    std::vector<Gap> next;
    for (const auto& row : parted(asked, gaps, 2, search.stop, search.threads)) {
      if (row.size() < 3 || !may_hide_a_window(row[0], row[1], row[2], search)) continue;
      stations.push_back(row[1]);
      next.push_back({row[0], row[1]}), next.push_back({row[1], row[2]});
    }
    gaps = std::move(next);
  }
  std::ranges::sort(stations, {}, &Station::amplitude);
  return stations;
}

/// So many amplitudes are asked at once at least, to keep the lanes of the kernel busy.
constexpr int together = 16;

int parts_of(const std::vector<Gap>& gaps) {
  return std::max(2, together / std::max(1, static_cast<int>(gaps.size())));
}

/// Stations beside each amplitude at which a chain of impacts just comes to rest, where some overturn near
/// it. There windows follow each other in a geometric sequence, ever narrower; so do these stations.
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
    for (std::size_t i = 0; const auto& row : parted(asked, gaps, together, search.stop, search.threads)) {
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
  return stations_at(asked, amplitudes, search.stop, search.threads);
}

/// The stations beside a change of code once more, exactly: one next to an edge may change sides.
void settle(const PulseCase& asked, std::vector<Station>& stations, Stop stop) {
  std::vector<bool> settled(stations.size(), asked.engine == Engine::gsl);
  for (bool changed = true; changed;) {
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const bool beside = (i > 0 && stations[i - 1].code() != stations[i].code()) ||
                          (i + 1 < stations.size() && stations[i].code() != stations[i + 1].code());
      if (beside && !settled[i]) which.push_back(i);
    }
    std::vector<double> amplitudes;
    for (const std::size_t i : which) amplitudes.push_back(stations[i].amplitude), settled[i] = true;
    const auto again = stations_at(exactly(asked), amplitudes, stop);
    for (std::size_t k = 0; k < which.size(); ++k) stations[which[k]] = again[k];
    changed = !which.empty();
  }
}

bool are_neighbours(double low, double high) { return !(std::nextafter(low, high) < high); }

/// The changes of code, in order, each between neighbouring numbers.
std::vector<Gap> changes_between(const PulseCase& asked, std::vector<Station> stations, Stop stop) {
  settle(asked, stations, stop);
  std::vector<Gap> gaps, changes;
  const auto add_changes = [&](const std::vector<Station>& row, std::vector<Gap>& open) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      if (row[i].code() != row[i + 1].code())
        (are_neighbours(row[i].amplitude, row[i + 1].amplitude) ? changes : open)
            .push_back({row[i], row[i + 1]});
  };
  add_changes(stations, gaps);
  while (!gaps.empty()) {
    std::vector<Gap> next;
    for (const auto& row : parted(exactly(asked), gaps, parts_of(gaps), stop)) add_changes(row, next);
    gaps = std::move(next);
  }
  std::ranges::sort(changes, {}, [](const Gap& change) { return change.low.amplitude; });
  return changes;
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

/// The first amplitudes, crowded towards the smallest.
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

/// The windows between the first and the last of some amplitudes.
std::vector<Window> windows_among(const PulseCase& asked, const WindowSearch& search,
                                  const std::vector<double>& amplitudes) {
  std::vector<Window> windows;
  if (amplitudes.empty()) return windows;
  PulseCase glancing = asked;
  if (asked.engine == Engine::taylor) glancing.tolerance = std::max(asked.tolerance, search.glance);
  std::vector<Station> stations = scan(glancing, search, amplitudes);
  const std::vector<Station> more = beside_chains(glancing, search, stations);
  stations.insert(stations.end(), more.begin(), more.end());
  std::ranges::sort(stations, {}, &Station::amplitude);
  double from = stations.front().amplitude;
  int code = stations.front().code();
  for (const auto& [before, after] : changes_between(asked, stations, search.stop)) {
    if (code != 0) windows.push_back({from, before.amplitude, code});
    from = after.amplitude, code = after.code();
  }
  if (code != 0) windows.push_back({from, std::nullopt, code});
  return wide_enough(windows, asked.model);
}

}  // namespace

PulseCase exactly(PulseCase asked) {
  if (asked.model == Model::linear) asked.engine = Engine::gsl;
  if (asked.engine == Engine::taylor) asked.tolerance = 1e-15;
  return asked;
}

Change edge_of_code(const PulseCase& asked, int code, double inside, double outside) {
  const bool rises = inside < outside;
  std::vector<Station> ends = stations_at(exactly(asked), {inside, outside});
  if (ends[0].code() != code || ends[1].code() == code)
    throw std::invalid_argument(fmt::format("code {} must hold at {} and not at {}", code, inside, outside));
  if (!rises) std::swap(ends[0], ends[1]);
  while (!are_neighbours(ends[0].amplitude, ends[1].amplitude)) {
    const auto row = parted(exactly(asked), {{ends[0], ends[1]}}, together).front();
    std::size_t i = rises ? 0 : row.size() - 2;  // the change nearest to `inside`
    while ((row[i].code() == code) == (row[i + 1].code() == code)) rises ? ++i : --i;
    ends = {row[i], row[i + 1]};
  }
  if (!rises) std::swap(ends[0], ends[1]);
  return {ends[0].amplitude, ends[1].amplitude};
}

std::vector<Window> overturning_windows(const PulseCase& asked, const WindowSearch& search) {
  const std::vector<double> all = first_amplitudes(asked, search);
  if (!search.least) return windows_among(asked, search, all);
  constexpr std::ptrdiff_t some = 64;
  for (auto from = all.begin(); from != all.end();) {
    const auto to = from + std::min(some, all.end() - from - 1);
    if (const auto windows = windows_among(asked, search, {from, to + 1}); !windows.empty())
      return {{windows.front().from, std::nullopt, windows.front().code}};
    from = to + 1 == all.end() ? all.end() : to;
  }
  return {};
}

std::optional<Window> least_window(const std::vector<Window>& windows) {
  if (windows.empty()) return std::nullopt;
  return windows.front();
}

}  // namespace rederive::inline numeric
