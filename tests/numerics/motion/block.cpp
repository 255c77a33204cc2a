#include <doctest/doctest.h>

#include <cmath>
#include <emitted/rocking_block.hpp>
#include <limits>
#include <numerics/motion/block.hpp>
#include <stdexcept>

using namespace rederive::numerics;

TEST_CASE("a block is given by its stockiness or by its size") {
  const Block by_size = block_from_size(0.11, 1.0);
  CHECK(by_size.alpha == doctest::Approx(std::atan(0.11)).epsilon(1e-15));
  CHECK(by_size.p == doctest::Approx(std::sqrt(3 * 9.81 / (4 * std::hypot(0.11, 1.0)))).epsilon(1e-14));
  CHECK(by_size.restitution ==
        doctest::Approx(1 - 1.5 * std::pow(std::sin(std::atan(0.11)), 2)).epsilon(1e-14));
  CHECK(make_block(0.25, 2.14, 0.7).restitution == 0.7);
}

TEST_CASE("values out of range are refused by name") {
  const double nan = std::numeric_limits<double>::quiet_NaN(),
               infinity = std::numeric_limits<double>::infinity();
  for (double alpha : {0.0, -0.1, 1.5708, nan, infinity})
    CHECK_THROWS_AS(make_block(alpha, 2.14), std::invalid_argument);
  for (double p : {0.0, -1.0, nan, infinity}) CHECK_THROWS_AS(make_block(0.25, p), std::invalid_argument);
  for (double e : {0.0, -0.5, 1.0001, nan}) CHECK_THROWS_AS(make_block(0.25, 2.14, e), std::invalid_argument);
  CHECK_THROWS_WITH_AS(make_block(1.2, 2.14), doctest::Contains("restitution by equation (46)"),
                       std::invalid_argument);
  CHECK_NOTHROW(make_block(1.5, 2.14, 0.5));
  CHECK_THROWS_AS(block_from_size(0, 1), std::invalid_argument);
}

TEST_CASE("rocking starts where the ground acceleration turns the block off its rest") {
  for (Model model : {Model::linear, Model::nonlinear})
    for (double alpha : {1e-6, 0.1, 0.25, 1.0, 1.5}) {
      const Block block = make_block(alpha, 2.14, 0.9);
      const Real level = start_level(block, model);
      CHECK(std::abs(acceleration(block, model, -1, 0, level)) < 1e-12L * level);
      CHECK(acceleration(block, model, -1, 0, 1.01L * level) < 0);
      CHECK(acceleration(block, model, -1, 0, 0.99L * level) > 0);
      CHECK(acceleration(block, model, 1, 0, -1.01L * level) > 0);
    }
}

TEST_CASE("the two sides mirror each other") {
  for (Model model : {Model::linear, Model::nonlinear})
    for (Real angle : {0.1L, 0.7L, 1.3L})
      for (Real ground : {-2.0L, 0.3L, 4.0L}) {
        const Block block = make_block(0.3, 2.14);
        CHECK(static_cast<double>(acceleration(block, model, -1, -angle, ground)) ==
              doctest::Approx(static_cast<double>(-acceleration(block, model, 1, angle, -ground)))
                  .epsilon(1e-15));
      }
}

TEST_CASE("the emitted derivative of the angular acceleration passes a Taylor test") {
  // The remainder f(x+h) - f(x) - h f'(x) falls by four when h is halved.
  const Real alpha = 0.25L, p = 1, ground = 0.7L, theta = -0.1L;
  const auto at = rederive::emitted::angular_acceleration_negative_with_derivatives(alpha, p, theta, ground);
  Real before = 0;
  for (int i = 0; i < 6; ++i) {
    const Real h = std::ldexp(0.05L, -i);
    const Real rest = std::abs(rederive::emitted::angular_acceleration_negative(alpha, p, theta + h, ground) -
                               at.value - h * at.d_theta);
    if (i > 2) CHECK(before / rest == doctest::Approx(4).epsilon(0.05));
    before = rest;
  }
}
