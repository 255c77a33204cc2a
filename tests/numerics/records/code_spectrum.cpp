#include <doctest/doctest.h>

#include <cmath>
#include <numerics/records/code_spectrum.hpp>
#include <stdexcept>

using namespace rederive::numerics;

TEST_CASE("EN 1998-1 Table 3.2 has grounds A to E") {
  CHECK(ground_types().size() == 5);
  for (char name : {'A', 'B', 'C', 'D', 'E'}) CHECK(ground_type(name).name == name);
  CHECK_THROWS_AS(ground_type('F'), std::invalid_argument);
}

TEST_CASE("the damping correction is 1 at five percent and never below 0.55") {
  CHECK(damping_correction(5) == 1);
  CHECK(damping_correction(3) == doctest::Approx(std::sqrt(1.25)));
  CHECK(damping_correction(100) == 0.55);
  CHECK_THROWS_AS(damping_correction(-1), std::invalid_argument);
  CHECK_THROWS_AS(damping_correction(std::nan("")), std::invalid_argument);
}

TEST_CASE("the spectrum starts at a_g S, has its plateau at 2.5 eta a_g S, and is continuous") {
  for (const GroundType& ground : ground_types())
    for (double damping : {3.0, 5.0}) {
      const auto at = [&](double period) { return elastic_response(ground, 0.24, damping, period); };
      CHECK(at(0) == doctest::Approx(0.24 * ground.soil_factor));
      CHECK(at((ground.period_b + ground.period_c) / 2) ==
            doctest::Approx(0.24 * ground.soil_factor * 2.5 * damping_correction(damping)));
      for (double corner : {ground.period_b, ground.period_c, ground.period_d})
        CHECK(at(corner * (1 + 1e-12)) == doctest::Approx(at(corner)).epsilon(1e-9));
      CHECK(at(4) == doctest::Approx(at(2) / 4));
      CHECK_THROWS_AS(at(4.01), std::invalid_argument);
      CHECK_THROWS_AS(at(-0.1), std::invalid_argument);
    }
}
