#include <doctest/doctest.h>

#include <numerics/search/grid.hpp>
#include <stdexcept>

using namespace rederive::numerics;

TEST_CASE("a spectrum is its windows, whatever the number of threads") {
  PulseCase asked;
  asked.block = make_block(0.25, 2.14);
  const std::vector<double> ratios{1, 3, 5.5, 9};
  Work alone, four;
  four.threads = 4;
  const auto one = spectrum(asked, ratios, {12, 256, 2e-6}, alone);
  const auto many = spectrum(asked, ratios, {12, 256, 2e-6}, four);
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    CHECK(one[i].done);
    CHECK(one[i].minimum == many[i].minimum);
    CHECK(one[i].mode1 == many[i].mode1);
  }
  CHECK(one[0].mode1);
  CHECK(one[1].code == 2);
  CHECK(*one[1].mode2_lower == *one[1].minimum);
  CHECK(*one[1].mode2_upper < *one[1].mode1);
  CHECK(!one[3].minimum);
}

TEST_CASE("a spectrum of least amplitudes has those among chains of impacts, with any number of threads") {
  PulseCase asked;
  asked.block = make_block(0.25, 2.14, 0.95);
  Work alone, two;
  two.threads = 2;
  const std::vector<double> ratios{0.1, 0.2, 2};
  const auto points = spectrum(asked, ratios, {.least = true}, alone);
  CHECK(*points[0].minimum == doctest::Approx(1.00496169321666).epsilon(1e-12));  // by random amplitudes
  CHECK(*points[1].minimum == doctest::Approx(1.01509119589102).epsilon(1e-12));
  CHECK(std::pair(points[0].code, points[1].code) == std::pair(138, 50));
  const auto again = spectrum(asked, ratios, {.least = true}, two), whole = spectrum(asked, ratios, {}, two);
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    CHECK(again[i].minimum == points[i].minimum);
    CHECK(*whole[i].minimum == doctest::Approx(*points[i].minimum).epsilon(1e-14));
  }
}

TEST_CASE("an interruption keeps what is done, and an error comes through") {
  std::atomic<bool> stop{false};
  Work work;
  work.count = 100;
  work.stop = &stop;
  int seen = 0;
  CHECK(for_each_index(work, [&](int) { stop = ++seen == 7; }) == 7);
  stop = false;
  work.threads = 3;
  CHECK_THROWS_AS(for_each_index(work,
                                 [](int i) {
                                   if (i == 5) throw std::runtime_error("five");
                                 }),
                  std::runtime_error);
}
