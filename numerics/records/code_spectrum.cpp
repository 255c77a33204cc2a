#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numerics/records/code_spectrum.hpp>
#include <stdexcept>

namespace rederive::numerics {

const std::vector<GroundType>& ground_types() {
  static const std::vector<GroundType> table{{'A', 1.0, 0.15, 0.4, 2.0},
                                             {'B', 1.2, 0.15, 0.5, 2.0},
                                             {'C', 1.15, 0.20, 0.6, 2.0},
                                             {'D', 1.35, 0.20, 0.8, 2.0},
                                             {'E', 1.4, 0.15, 0.5, 2.0}};
  return table;
}

const GroundType& ground_type(char name) {
  for (const GroundType& ground : ground_types())
    if (ground.name == name) return ground;
  throw std::invalid_argument(fmt::format("ground type '{}' is not one of A, B, C, D, E", name));
}

double damping_correction(double damping_percent) {
  if (!(damping_percent >= 0 && damping_percent <= 100))
    throw std::invalid_argument(
        fmt::format("damping = {} percent must lie between 0 and 100", damping_percent));
  return std::max(0.55, std::sqrt(10 / (5 + damping_percent)));
}

double elastic_response(const GroundType& ground, double ground_acceleration, double damping_percent,
                        double period) {
  if (!(period >= 0 && period <= 4))
    throw std::invalid_argument(fmt::format("period = {} s must lie between 0 and 4 s", period));
  if (!(ground_acceleration >= 0 && std::isfinite(ground_acceleration)))
    throw std::invalid_argument(
        fmt::format("ground acceleration = {} must not be negative", ground_acceleration));
  const double plateau = 2.5 * damping_correction(damping_percent);
  const double scale = ground_acceleration * ground.soil_factor;
  if (period <= ground.period_b) return scale * (1 + period / ground.period_b * (plateau - 1));
  if (period <= ground.period_c) return scale * plateau;
  if (period <= ground.period_d) return scale * plateau * ground.period_c / period;
  return scale * plateau * ground.period_c * ground.period_d / (period * period);
}

}  // namespace rederive::numerics
