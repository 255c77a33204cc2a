#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numerics/search/edges.hpp>
#include <stdexcept>

namespace rederive::numerics {
namespace {

int parts_of(const std::vector<Gap>& gaps) {
  return std::max(2, together / std::max(1, static_cast<int>(gaps.size())));
}

/// Computes the stations beside a change of code again, in the way in which edges are found: a station next
/// to an edge may change sides.
void settle(const PulseCase& precise, std::vector<Station>& stations, const WindowSearch& search) {
  std::vector<bool> settled(stations.size(), precise.engine == Engine::gsl);
  for (bool changed = true; changed;) {
    std::vector<std::size_t> which;
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const bool beside = (i > 0 && stations[i - 1].code() != stations[i].code()) ||
                          (i + 1 < stations.size() && stations[i].code() != stations[i + 1].code());
      if (beside && !settled[i]) which.push_back(i);
    }
    std::vector<double> amplitudes;
    for (const std::size_t i : which) amplitudes.push_back(stations[i].amplitude), settled[i] = true;
    const auto again = stations_at(precise, amplitudes, search);
    for (std::size_t k = 0; k < which.size(); ++k) stations[which[k]] = again[k];
    changed = !which.empty();
  }
}

bool are_neighbours(double low, double high) { return !(std::nextafter(low, high) < high); }

/// Adds the changes of code along a row of stations: changes between neighbouring numbers to `changes`, all
/// others to `open`.
void add_changes(const std::vector<Station>& row, std::vector<Gap>& changes, std::vector<Gap>& open) {
  for (std::size_t i = 0; i + 1 < row.size(); ++i)
    if (row[i].code() != row[i + 1].code())
      (are_neighbours(row[i].amplitude, row[i + 1].amplitude) ? changes : open)
          .push_back({row[i], row[i + 1]});
}

/// Returns the changes of code in some gaps, each between neighbouring numbers.
std::vector<Gap> narrowed(const PulseCase& asked, std::vector<Gap> gaps, const WindowSearch& search) {
  std::vector<Gap> changes;
  while (!gaps.empty()) {
    const int parts = asked.engine == Engine::gsl ? 2 : parts_of(gaps);
    std::vector<Gap> next;
    for (const auto& row : parted(asked, gaps, parts, search)) add_changes(row, changes, next);
    gaps = std::move(next);
  }
  return changes;
}

/// Returns whether closed forms are asked for a change that the kernel found: always for the edges of the
/// first window, and for others after at most 100 impacts. A motion by closed forms takes a hundred times as
/// long as by the kernel, and ends with the same edge to 1e-13.
bool is_confirmed(std::size_t index, const Gap& change) {
  constexpr int most_impacts = 100;
  return index < 2 || std::max(change.low.outcome.impacts, change.high.outcome.impacts) <= most_impacts;
}

/// Returns stations of closed forms around some changes that the kernel found. They extend until the codes
/// before the first change and after the last change are confirmed, within `least` and `most`.
std::vector<Station> confirmed_row(const PulseCase& exact, const Gap& first, const Gap& last, double least,
                                   double most, const WindowSearch& search) {
  const double low = first.low.amplitude, high = last.high.amplitude;
  std::vector<Station> row = stations_at(exact, {low, high}, search);
  for (double distance = 0x1p-50; distance < 0x1p-10; distance *= 16) {
    if (row.front().code() == first.low.code() && row.back().code() == last.high.code()) break;
    const double below = low * (1 - distance), above = high * (1 + distance);
    if (least < below) row.insert(row.begin(), stations_at(exact, {below}, search).front());
    if (above < most) row.push_back(stations_at(exact, {above}, search).front());
  }
  return row;
}

/// Returns the changes of the linear model according to the closed forms: where the kernel has them, or close
/// beside. Where rounding makes the kernel change the code several times at one edge, the closed forms are
/// evaluated once.
std::vector<Gap> confirmed(const PulseCase& asked, const std::vector<Gap>& found,
                           const WindowSearch& search) {
  constexpr double one_edge = 1 + 0x1p-44;
  const PulseCase exact = exactly(asked);
  std::vector<Gap> changes, open;
  for (std::size_t i = 0, next = 0; i < found.size(); i = next) {
    const std::size_t last = [&] {
      std::size_t k = i;
      while (k + 1 < found.size() && found[k + 1].low.amplitude < found[k].high.amplitude * one_edge) ++k;
      return k;
    }();
    next = last + 1;
    if (!is_confirmed(i, found[i])) {
      changes.insert(changes.end(), found.begin() + i, found.begin() + next);
      continue;
    }
    const double least = i == 0 ? 0 : found[i - 1].high.amplitude,
                 most = next == found.size() ? 2 * found[last].high.amplitude : found[next].low.amplitude;
    add_changes(confirmed_row(exact, found[i], found[last], least, most, search), changes, open);
  }
  const std::vector<Gap> more = narrowed(exact, std::move(open), search);
  changes.insert(changes.end(), more.begin(), more.end());
  return changes;
}

}  // namespace

/// Returns the changes of code in order, each between neighbouring numbers.
std::vector<Gap> changes_between(const PulseCase& asked, std::vector<Station> stations,
                                 const WindowSearch& search) {
  PulseCase precise = asked;
  if (asked.engine == Engine::taylor) precise.tolerance = 1e-15;
  settle(precise, stations, search);
  std::vector<Gap> changes, open;
  add_changes(stations, changes, open);
  const std::vector<Gap> more = narrowed(precise, std::move(open), search);
  changes.insert(changes.end(), more.begin(), more.end());
  const auto order = [](const Gap& change) { return change.low.amplitude; };
  std::ranges::sort(changes, {}, order);
  if (asked.model == Model::linear && asked.engine == Engine::taylor) {
    changes = confirmed(asked, changes, search);
    std::ranges::sort(changes, {}, order);
  }
  return changes;
}

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

}  // namespace rederive::numerics
