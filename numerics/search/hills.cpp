#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <numeric>
#include <numerics/motion/batch.hpp>
#include <numerics/search/stations.hpp>
#include <optional>

namespace rederive::numerics {
namespace {

/// An amplitude with its outcome, and how far the chain of impacts had come when the last push began.
struct Spot {
  Station station;
  int impacts = 0;         ///< before that push, since the last rest
  bool rests = false;      ///< when it begins, or has not moved yet
  double height() const {  ///< above the barrier; below 0 where it does not overturn
    if (station.code() != 0) return 1;
    return static_cast<double>(std::max(station.outcome.margins.outward, station.outcome.margins.returning));
  }
  double amplitude() const { return station.amplitude; }
};

using Spots = std::vector<Spot>;

bool is_in_window(const Spot& spot) { return spot.station.code() != 0; }

class HillSearch {
 public:
  HillSearch(const PulseCase& asked, const WindowSearch& search, double lowest, const Station& overturns)
      : asked_(asked), search_(search), lowest_(lowest), finest_(overturns.amplitude * 1e-12) {
    if (asked_.engine == Engine::taylor) asked_.tolerance = 1e-15;
    top_ = spots_at({overturns.amplitude}).front();
  }

  std::vector<Station> found() {
    double distance = first_share * (top_.amplitude() - lowest_), before = 1;
    int hills = first_hills, falling = 0;
    while (falling < enough_groups && top_.amplitude() > lowest_) {
      const std::optional<Spot> bottom = bottom_of_group(distance, hills);
      if (!bottom) break;
      distance = 4 * (top_.amplitude() - bottom->amplitude());
      const Spots row = climbed(resolved(*bottom));
      const auto window = std::ranges::find_if(row, is_in_window);
      const bool has_window = window < row.end() - 1;
      double height = -1;
      for (auto at = row.begin(); at < window; ++at) height = std::max(height, at->height());
      falling = !has_window && height < before ? falling + 1 : 0;
      hills = has_window ? first_hills : 2 * hills;
      before = height;
      top_ = *bottom;
    }
    return std::move(stations_);
  }

 private:
  static constexpr double first_share = 1e-3;
  static constexpr int first_hills = 8, enough_groups = 4, halvings = 3;
  static constexpr std::size_t most_spots = 50'000;  ///< of a group

  Spots spots_at(const std::vector<double>& amplitudes) {
    const std::vector<Station> stations = stations_at(asked_, amplitudes, search_);
    const std::vector<Outcome> before = outcomes_before_last_push(asked_, amplitudes, search_.threads);
    Spots row;
    for (std::size_t i = 0; i < stations.size(); ++i)
      row.push_back({stations[i], before[i].impacts, before[i].side == 0});
    stations_.insert(stations_.end(), stations.begin(), stations.end());
    return row;
  }

  /// Returns the least number of hills between two spots; a large number if the chain of only one of them
  /// ends.
  static int hills_between(const Spot& a, const Spot& b) {
    if (a.rests != b.rests) return 1'000'000;
    return std::abs(a.impacts - b.impacts) / 2;
  }

  /// Returns the lowest of some amplitudes below the top, the farthest `distance` away, such that at most a
  /// given number of hills lie between; returns none if the hills are narrower than `finest_`. While a chain
  /// lasts, no amplitude is more than half-way to the lowest one, at which a motion without loss has
  /// infinitely many impacts.
  std::optional<Spot> bottom_of_group(double distance, int hills) {
    if (!top_.rests) distance = std::min(distance, (top_.amplitude() - lowest_) / 2);
    for (; distance > finest_; distance /= 256) {
      std::vector<double> amplitudes;
      for (int i = 0; i < 8; ++i) {
        const double amplitude = std::max(lowest_, top_.amplitude() - std::ldexp(distance, -i));
        if (amplitudes.empty() || amplitude > amplitudes.back()) amplitudes.push_back(amplitude);
      }
      const std::vector<Outcome> before = outcomes_before_last_push(asked_, amplitudes, search_.threads);
      for (std::size_t i = 0; i < amplitudes.size(); ++i) {
        const Spot spot{{}, before[i].impacts, before[i].side == 0};
        if (hills_between(spot, top_) <= hills && amplitudes[i] < top_.amplitude())
          return spots_at({amplitudes[i]}).front();
      }
    }
    return std::nullopt;
  }

  /// Returns spots from the bottom to the top of a group, so many that each hill has some.
  Spots resolved(const Spot& bottom) {
    struct Stretch {
      Spot low, high;
      int halvings;
    };
    constexpr int parts = 8;
    std::vector<double> amplitudes;
    for (int i = 1; i < parts; ++i) {
      const double amplitude =
          std::lerp(bottom.amplitude(), top_.amplitude(), static_cast<double>(i) / parts);
      if (bottom.amplitude() < amplitude && amplitude < top_.amplitude()) amplitudes.push_back(amplitude);
    }
    Spots row = spots_at(amplitudes);
    row.insert(row.begin(), bottom), row.push_back(top_);
    std::vector<Stretch> stretches;
    const auto hills = static_cast<unsigned>(hills_between(bottom, top_));
    const int more = std::min<int>(halvings, std::bit_width(hills));
    for (std::size_t i = 0; i + 1 < row.size(); ++i) stretches.push_back({row[i], row[i + 1], more});
    while (!stretches.empty() && row.size() < most_spots) {
      double lowest_window = top_.amplitude();
      for (const Spot& spot : row)
        if (is_in_window(spot)) lowest_window = std::min(lowest_window, spot.amplitude());
      std::erase_if(stretches, [&](const Stretch& stretch) {
        const bool has_many = hills_between(stretch.low, stretch.high) > 1;
        return stretch.high.amplitude() - stretch.low.amplitude() < finest_ ||
               stretch.low.amplitude() >= lowest_window || (!has_many && stretch.halvings == 0);
      });
      amplitudes.clear();
      for (const auto& [low, high, more] : stretches)
        amplitudes.push_back(std::midpoint(low.amplitude(), high.amplitude()));
      const Spots middles = spots_at(amplitudes);
      std::vector<Stretch> next;
      for (std::size_t i = 0; i < middles.size(); ++i) {
        const auto& [low, high, more] = stretches[i];
        const int left = hills_between(low, high) > 1 ? halvings : more - 1;
        next.push_back({low, middles[i], left}), next.push_back({middles[i], high, left});
        row.push_back(middles[i]);
      }
      stretches = std::move(next);
    }
    std::ranges::sort(row, {}, &Spot::amplitude);
    return row;
  }

  /// Adds the tops of the hills below the lowest window.
  Spots climbed(Spots row) {
    const double flat = 0.02 * std::min(1.0, asked_.omega_ratio);
    const auto lowest_window = std::ranges::find_if(row, is_in_window);
    std::vector<std::array<Spot, 3>> hills;
    for (auto at = row.begin() + 1; at < row.end() - 1 && at < lowest_window; ++at)
      if (at->height() >= (at - 1)->height() && at->height() >= (at + 1)->height())
        hills.push_back({*(at - 1), *at, *(at + 1)});
    while (!hills.empty()) {
      std::erase_if(hills, [&](const std::array<Spot, 3>& hill) {
        const double rise = hill[1].height() - std::min(hill[0].height(), hill[2].height());
        return is_in_window(hill[1]) || rise < flat || hill[2].amplitude() - hill[0].amplitude() < finest_;
      });
      std::vector<double> amplitudes;
      for (const auto& hill : hills)
        for (int i = 0; i < 2; ++i)
          amplitudes.push_back(std::midpoint(hill[i].amplitude(), hill[i + 1].amplitude()));
      const Spots between = spots_at(amplitudes);
      row.insert(row.end(), between.begin(), between.end());
      for (std::size_t i = 0; i < hills.size(); ++i) {
        const std::array<Spot, 5> all{hills[i][0], between[2 * i], hills[i][1], between[2 * i + 1],
                                      hills[i][2]};
        const auto best = std::max_element(all.begin() + 1, all.end() - 1, [](const Spot& a, const Spot& b) {
          return a.height() < b.height();
        });
        hills[i] = {*(best - 1), *best, *(best + 1)};
      }
    }
    std::ranges::sort(row, {}, &Spot::amplitude);
    return row;
  }

  PulseCase asked_;
  const WindowSearch& search_;
  double lowest_, finest_;
  Spot top_;
  std::vector<Station> stations_;
};

}  // namespace

std::vector<Station> stations_below(const PulseCase& asked, const WindowSearch& search, double lowest,
                                    const Station& overturns) {
  return HillSearch(asked, search, lowest, overturns).found();
}

}  // namespace rederive::numerics
