#include <doctest/doctest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <numerics/motion/ground_motion.hpp>
#include <numerics/motion/response.hpp>
#include <numerics/records/record.hpp>
#include <stdexcept>
#include <tests/run_program.hpp>

using namespace rederive::numerics;

namespace {

std::string written(const TemporaryFolder& folder, const std::string& text) {
  const auto path = folder.path / "record.txt";
  std::ofstream(path) << text;
  return path;
}

}  // namespace

TEST_CASE("a sine pulse begins where it can start the block and ends after its whole wave") {
  const Piece piece = pulse_motion(Pulse::sine, 3, 2, 1).front();
  CHECK(ground_at(piece, 0) == doctest::Approx(1).epsilon(1e-15));
  CHECK(ground_at(piece, 0.01L) > 1);
  CHECK(std::abs(ground_at(piece, piece.to)) < 1e-15L);
  CHECK(static_cast<double>(piece.to) ==
        doctest::Approx((2 * std::numbers::pi - std::asin(0.5)) / 3).epsilon(1e-15));
}

TEST_CASE("a cosine pulse begins falling and ends at three quarters of its wave") {
  const Piece piece = pulse_motion(Pulse::cosine, 3, 2, 1).front();
  CHECK(ground_at(piece, 0) == doctest::Approx(1).epsilon(1e-15));
  CHECK(ground_at(piece, 0.01L) < 1);
  CHECK(static_cast<double>(piece.to) ==
        doctest::Approx((1.5 * std::numbers::pi - std::acos(0.5)) / 3).epsilon(1e-15));
  for (Real t : {0.1L, 0.5L, 1.0L})
    CHECK(static_cast<double>(ground_at(piece, t)) ==
          doctest::Approx(2 * std::cos(3 * static_cast<double>(t) + std::acos(0.5))).epsilon(1e-14));
}

TEST_CASE("pushes are the stretches above the level, the first of a cosine pulse being over at its start") {
  const auto sine = pushes(pulse_motion(Pulse::sine, 2, 3, 1).front(), 1);
  REQUIRE(sine.size() == 2);
  CHECK(sine[0].from == 0);
  CHECK(sine[0].side == -1);
  CHECK(sine[1].side == 1);
  const auto cosine = pushes(pulse_motion(Pulse::cosine, 2, 3, 1).front(), 1);
  REQUIRE(cosine.size() == 1);
  CHECK(cosine[0].side == 1);
  CHECK(static_cast<double>(cosine[0].from) ==
        doctest::Approx((std::numbers::pi - 2 * std::acos(1.0 / 3)) / 2));
  CHECK(pushes(pulse_motion(Pulse::sine, 2, 1, 1).front(), 1).empty());
}

TEST_CASE("bounds hold everywhere in between") {
  const Piece piece = pulse_motion(Pulse::sine, 5, 2.5L, 1).front();
  for (int i = 0; i < 20; ++i)
    for (int j = i + 1; j <= 20; ++j) {
      const Real from = piece.to * i / 20, to = piece.to * j / 20;
      const Range range = ground_range(piece, from, to);
      CHECK(most_ground(piece, from, to) ==
            doctest::Approx(static_cast<double>(std::max(range.high, -range.low))).epsilon(1e-14));
      for (int k = 0; k <= 30; ++k) {
        const Real value = ground_at(piece, from + (to - from) * k / 30);
        CHECK(value <= range.high + 1e-15L);
        CHECK(value >= range.low - 1e-15L);
      }
    }
}

TEST_CASE("impossible pulses are refused") {
  const Real nan = std::numeric_limits<Real>::quiet_NaN();
  for (Real ratio : {0.0L, -1.0L, nan})
    CHECK_THROWS_AS(pulse_motion(Pulse::sine, ratio, 2, 1), std::invalid_argument);
  for (Real amplitude : {0.5L, -2.0L, nan, std::numeric_limits<Real>::infinity()})
    CHECK_THROWS_AS(pulse_motion(Pulse::sine, 2, amplitude, 1), std::invalid_argument);
}

TEST_CASE("records are read in their usual layouts") {
  const TemporaryFolder folder;
  const Record two =
      read_record(written(folder, "# s, g\n0 0\n0.01, 0.5\n0.03;-0.25\n"), {.unit = RecordUnit::g});
  CHECK(two.time == std::vector<double>{0, 0.01, 0.03});
  CHECK(two.acceleration == std::vector<double>{0, 0.5, -0.25});
  const Record one = read_record(written(folder, "9.81\n-19.62\n"),
                                 {.unit = RecordUnit::metres_per_second_squared, .step = 0.02});
  CHECK(one.time == std::vector<double>{0, 0.02});
  CHECK(one.acceleration == std::vector<double>{1, -2});
  const Record peer = read_record(written(folder,
                                          "PEER NGA\nSomewhere\nACCELERATION IN UNITS OF G\n"
                                          "NPTS=    5, DT=   .0050 SEC,\n .1E-01 -.2E-01 .3 \n .4 .5\n"),
                                  {.unit = RecordUnit::metres_per_second_squared});
  CHECK(peer.acceleration == std::vector<double>{0.01, -0.02, 0.3, 0.4, 0.5});
  CHECK(peer.time[4] == doctest::Approx(0.02));
}

TEST_CASE("what cannot be read is refused with file and line") {
  const TemporaryFolder folder;
  for (const char* text : {"", "0 1\n", "0 1\n0 2\n", "0 1\n1 nan\n", "0 1\n1 inf\n", "0 1\n1 x\n",
                           "0 1 2\n1 2 3\n", "1\n2\n", "0 1\n1 1e999\n", "\x01\x02\x03"})
    CHECK_THROWS_AS(read_record(written(folder, text), {.unit = RecordUnit::g}), std::invalid_argument);
  CHECK_THROWS_WITH_AS(read_record(written(folder, "0 1\n1 x\n"), {.unit = RecordUnit::g}),
                       doctest::Contains("record.txt:2"), std::invalid_argument);
  CHECK_THROWS_AS(read_record("/nowhere/at/all", {.unit = RecordUnit::g}), std::invalid_argument);
  CHECK_THROWS_AS(read_record(folder.path, {.unit = RecordUnit::g}), std::invalid_argument);
}

TEST_CASE("a record is interpolated linearly in units of alpha g against p t") {
  const Block block = make_block(0.25, 2);
  const auto motion = record_motion({{1, 2, 4}, {0, 0.5, -0.5}}, block);
  REQUIRE(motion.size() == 2);
  CHECK(motion[1].to == 6);
  CHECK(ground_at(motion[0], 1) == doctest::Approx(1).epsilon(1e-15));
  CHECK(std::abs(ground_at(motion[1], 4)) < 1e-15L);
  CHECK(most_ground(motion[1], 2, 4) ==
        doctest::Approx(static_cast<double>(std::abs(ground_at(motion[1], 2)))));
  const auto all = pushes(motion[1], 1);
  REQUIRE(all.size() == 2);
  CHECK(all[0].to == doctest::Approx(3));
  CHECK(all[1].from == doctest::Approx(5));
}

TEST_CASE("a record that turns at every sample is followed to its end, even without loss at impacts") {
  const Block block = make_block(0.25, 2.14, 1);
  Record record;
  for (int i = 0; i < 8000; ++i)
    record.time.push_back(i * 0.01), record.acceleration.push_back(i % 2 == 0 ? 0.4 : -0.4);
  for (Model model : {Model::linear, Model::nonlinear})
    CHECK(respond(block, model, record_motion(record, block), {}).end.time ==
          doctest::Approx(79.99 * 2.14).epsilon(1e-12));
}

TEST_CASE("a record in the shape of a pulse moves the block as the pulse does") {
  const Block block = make_block(0.25, 2.14);
  const auto pulse = pulse_motion(Pulse::sine, 2, 2, 1);
  Record record;
  const int count = 20'000;
  for (int i = 0; i <= count; ++i) {
    const Real tau = pulse[0].to * i / count;
    record.time.push_back(static_cast<double>(tau / block.p));
    record.acceleration.push_back(static_cast<double>(ground_at(pulse[0], tau) * block.alpha));
  }
  for (Model model : {Model::linear, Model::nonlinear}) {
    const auto level = start_level(block, model);
    const auto by_pulse = respond(block, model, pulse_motion(Pulse::sine, 2, 2 * level, level), {}).end;
    const auto by_record =
        respond(block, model, record_motion(record, block, static_cast<double>(level)), {}).end;
    CHECK(static_cast<double>(by_record.angle) ==
          doctest::Approx(static_cast<double>(by_pulse.angle)).epsilon(1e-6));
  }
}
