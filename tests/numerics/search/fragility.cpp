// The lognormal curve of a share that overturns, and what it is fitted to.
#include <doctest/doctest.h>

#include <cmath>
#include <numerics/search/fragility.hpp>
#include <random>
#include <stdexcept>

using namespace rederive::numerics;

namespace {

using Outcomes = std::vector<std::vector<char>>;

/// So many of `records` overturn at each level, the last ones.
Outcomes outcomes_of(const std::vector<int>& overturned, int records) {
  Outcomes outcomes(static_cast<std::size_t>(records));
  for (int i = 0; i < records; ++i)
    for (const int count : overturned) outcomes[static_cast<std::size_t>(i)].push_back(i >= records - count);
  return outcomes;
}

/// Records that overturn from a capacity of theirs on, which is lognormal.
Outcomes drawn(std::mt19937& random, const std::vector<double>& peaks, int records, double median,
               double beta) {
  std::normal_distribution<double> normal;
  Outcomes outcomes(static_cast<std::size_t>(records));
  for (auto& record : outcomes) {
    const double capacity = median * std::exp(beta * normal(random));
    for (const double peak : peaks) record.push_back(peak >= capacity);
  }
  return outcomes;
}

double log_likelihood(const std::vector<double>& peaks, const std::vector<int>& overturned, int records,
                      double median, double beta) {
  double sum = 0;
  for (std::size_t j = 0; j < peaks.size(); ++j) {
    const double x = std::log(peaks[j] / median) / beta;
    sum += overturned[j] * std::log(std::erfc(-x / std::sqrt(2.0)) / 2) +
           (records - overturned[j]) * std::log(std::erfc(x / std::sqrt(2.0)) / 2);
  }
  return sum;
}

std::string why_none(const std::vector<double>& peaks, const std::vector<int>& overturned, int records) {
  const LognormalFit fit = lognormal_fit(peaks, outcomes_of(overturned, records));
  CHECK(fit.curve.has_value() == !fit.why_none.has_value());
  return fit.why_none ? words_for(*fit.why_none) : "";
}

std::vector<double> evenly(double from, double to, int count) {
  std::vector<double> all;
  for (int i = 0; i < count; ++i) all.push_back(from + (to - from) * i / (count - 1));
  return all;
}

}  // namespace

TEST_CASE("no other curve is as likely as the one that is fitted") {
  const std::vector<double> peaks{0.2, 0.3, 0.4, 0.6, 0.7, 0.8, 0.9, 1.0};
  const std::vector<int> overturned{0, 0, 0, 4, 6, 13, 12, 16};
  const LognormalFit fit = lognormal_fit(peaks, outcomes_of(overturned, 40));
  REQUIRE(fit.curve);
  const double median = fit.curve->median().value, beta = fit.curve->beta().value;
  const double most = log_likelihood(peaks, overturned, 40, median, beta);
  for (const double by : {-0.1, -1e-3, -1e-6, 1e-6, 1e-3, 0.1})
    for (const double and_by : {-0.1, -1e-3, 0.0, 1e-3, 0.1}) {
      CHECK(log_likelihood(peaks, overturned, 40, median * (1 + by), beta * (1 + and_by)) < most);
      CHECK(log_likelihood(peaks, overturned, 40, median * (1 + and_by), beta * (1 + by)) < most);
    }
  const Estimate half = fit.curve->at(median);
  CHECK(half.value == doctest::Approx(0.5));
  CHECK(half.low < 0.5);
  CHECK(half.high > 0.5);
}

TEST_CASE("of records with lognormal capacities the curve is theirs, and intervals hold it 19 times of 20") {
  std::mt19937 random(20151);
  const std::vector<double> peaks = evenly(0.1, 2, 20);
  const double median = 0.7, beta = 0.4;
  int samples = 0, by_median = 0, by_beta = 0, by_curve = 0;
  double sum = 0;
  for (; samples < 400; ++samples) {
    const LognormalFit fit = lognormal_fit(peaks, drawn(random, peaks, 60, median, beta));
    REQUIRE(fit.curve);
    const auto holds = [](const Estimate& in, double value) { return in.low <= value && value <= in.high; };
    by_median += holds(fit.curve->median(), median);
    by_beta += holds(fit.curve->beta(), beta);
    by_curve += holds(fit.curve->at(1.0), std::erfc(std::log(median) / beta / std::sqrt(2.0)) / 2);
    sum += std::log(fit.curve->median().value);
  }
  CHECK(std::exp(sum / samples) == doctest::Approx(median).epsilon(0.01));
  for (const int count : {by_median, by_curve}) {  // 380 ± 4.4 if each held 95 %
    CHECK(count > 366);
    CHECK(count < 394);
  }
  CHECK(by_beta > 340);  // of so few records it is known less well than its scatter tells
}

TEST_CASE("the unit of the peak is no part of the curve") {
  const std::vector<int> overturned{0, 1, 3, 7, 9};
  const auto fit = [&](double unit) {
    std::vector<double> peaks{0.2, 0.3, 0.5, 0.7, 1.1};
    for (double& peak : peaks) peak *= unit;
    return *lognormal_fit(peaks, outcomes_of(overturned, 10)).curve;
  };
  CHECK(fit(1000).median().value == doctest::Approx(1000 * fit(1).median().value));
  CHECK(fit(1000).beta().high == doctest::Approx(fit(1).beta().high));
  CHECK(fit(1000).at(400).low == doctest::Approx(fit(1).at(0.4).low));
}

TEST_CASE("where the likelihood has no maximum there is no curve, and the reason is given") {
  CHECK(why_none({1, 2, 3}, {0, 0, 0}, 5) == "none overturns up to 3");
  CHECK(why_none({1, 2, 3}, {5, 5, 5}, 5) == "all overturn from 1 on");
  CHECK(why_none({1, 2, 3, 4}, {0, 0, 5, 5}, 5) ==
        "none overturns up to 2 and all do from 3 on: no amplitude lies between");
  CHECK(why_none({1, 2, 3}, {0, 2, 5}, 5) ==
        "none overturns below 2 and all do above: only one amplitude lies between");
  CHECK(why_none({1, 2, 3}, {5, 2, 0}, 5) == "the share does not grow with the amplitude");
  CHECK(why_none({1, 2, 3}, {4, 3, 1}, 5) == "the share does not grow with the amplitude");
  CHECK(why_none({1, 2}, {2, 2}, 5) == "the share does not grow with the amplitude");
  CHECK(why_none({1}, {2}, 5) == "one amplitude makes no curve");
  CHECK(why_none({1, 2, 3, 4}, {0, 1, 0, 1}, 1) == "one record makes no curve");
  CHECK(why_none({1, 2, 3}, {0, 1, 4}, 5) == "");
}

TEST_CASE("the peak of a record: its acceleration, or the velocity, also between the samples") {
  const Record record{{0, 1, 3, 4}, {0, 0.2, -0.2, 0.0}};
  CHECK(peak_of(record, Peak::acceleration) == 0.2);
  CHECK(peak_of(record, Peak::velocity) == doctest::Approx(9.81 * (0.1 + 0.1)));  // at t = 2
  Record sine;
  for (int i = 0; i <= 1000; ++i)
    sine.time.push_back(i * 0.002), sine.acceleration.push_back(std::sin(std::acos(-1.0) * i * 0.002));
  CHECK(peak_of(sine, Peak::velocity) == doctest::Approx(9.81 * 2 / std::acos(-1.0)).epsilon(1e-5));
  CHECK_THROWS_AS(
      overturned_at(make_block(0.2, 2), Model::linear, {{0, 1}, {0, 0}}, Peak::acceleration, {1.0}),
      std::invalid_argument);
}

TEST_CASE("a block overturns under a record that is scaled past what it stands") {
  const Record record{{0, 0.5, 1.0, 1.5}, {0, 0.01, -0.01, 0}};
  const auto outcomes =
      overturned_at(make_block(0.2, 2), Model::nonlinear, record, Peak::acceleration, {0.1, 0.2, 0.8, 3.0});
  CHECK(outcomes == std::vector<char>{0, 0, 1, 1});
}
