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

/// Grounds A to E, Table 3.2 (Type 1).
const std::vector<GroundType>& ground_types();

/// Throws std::invalid_argument unless A to E.
const GroundType& ground_type(char name);

/// eta = sqrt(10/(5 + xi)) >= 0.55 for viscous damping xi in percent, eq (3.6).
double damping_correction(double damping_percent);

/// S_e(T) in the unit of `ground_acceleration` a_g, eqs (3.2) to (3.5), 0 <= T <= 4 s.
/// Throws std::invalid_argument outside.
double elastic_response(const GroundType& ground, double ground_acceleration, double damping_percent,
                        double period);

}  // namespace rederive::numerics
