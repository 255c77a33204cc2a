// Elastic response spectra of Eurocode 8, EN 1998-1:2004, Type 1.
#pragma once

#include <string_view>
#include <vector>

namespace rederive::numerics {

/// A row of Table 3.2: soil factor and corner periods in s.
struct GroundType {
  char name;
  double soil_factor, period_b, period_c, period_d;
};

/// Returns the grounds A to E of Table 3.2 (Type 1).
const std::vector<GroundType>& ground_types();

/// Returns the ground with this name. Throws std::invalid_argument unless it is A to E.
const GroundType& ground_type(char name);

/// Returns eta = sqrt(10/(5 + xi)) >= 0.55 for viscous damping xi from 0 to 100 percent, eq (3.6). Throws
/// std::invalid_argument for other values.
double damping_correction(double damping_percent);

/// Returns S_e(T) in the unit of the design ground acceleration `ground_acceleration`, eqs (3.2) to (3.5),
/// for a period T from 0 to 4 s and damping in percent. Throws std::invalid_argument for other values.
double elastic_response(const GroundType& ground, double ground_acceleration, double damping_percent,
                        double period);

}  // namespace rederive::numerics
