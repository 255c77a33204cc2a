#include <fmt/format.h>
#include <gsl/gsl_cdf.h>
#include <gsl/gsl_multimin.h>
#include <gsl/gsl_sf_erf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <numerics/motion/overturning.hpp>
#include <numerics/search/fragility.hpp>
#include <stdexcept>

namespace rederive::numerics {
namespace {

/// Returns ln Phi(x), also where Phi(x) is less than any double.
double log_normal(double x) { return gsl_sf_log_erfc(-x / std::numbers::sqrt2) - std::numbers::ln2; }

/// Returns the derivative of ln Phi, the density over Phi.
double slope_of_log_normal(double x) {
  return std::exp(-x * x / 2 - std::log(2 * std::numbers::pi) / 2 - log_normal(x));
}

using Symmetric = LineCovariance;
Symmetric operator*(double by, const Symmetric& m) { return {by * m.aa, by * m.ab, by * m.bb}; }
Symmetric operator+(const Symmetric& m, const Symmetric& n) {
  return {m.aa + n.aa, m.ab + n.ab, m.bb + n.bb};
}
Symmetric& operator+=(Symmetric& m, const Symmetric& n) { return m = m + n; }

/// Returns x with m x = y.
std::array<double, 2> solved(const Symmetric& m, const std::array<double, 2>& y) {
  const double determinant = m.aa * m.bb - m.ab * m.ab;
  return {(m.bb * y[0] - m.ab * y[1]) / determinant, (m.aa * y[1] - m.ab * y[0]) / determinant};
}

/// Of n records with peak u = ln x, z overturn the block.
struct Level {
  double u;
  int z, n;
};

/// Returns the derivative of the log likelihood of one outcome by eta = a + b u.
double score(double eta, bool overturned) {
  return overturned ? slope_of_log_normal(eta) : -slope_of_log_normal(-eta);
}

/// Returns minus the second derivative: h (h + eta) belongs to ln Phi, where h is the first derivative.
double curvature(double eta, bool overturned) {
  const double at = overturned ? eta : -eta, h = slope_of_log_normal(at);
  return h * (h + at);
}

double minus_log_likelihood(const gsl_vector* line, void* levels) {
  double sum = 0;
  for (const Level& level : *static_cast<const std::vector<Level>*>(levels)) {
    const double eta = gsl_vector_get(line, 0) + gsl_vector_get(line, 1) * level.u;
    if (level.z > 0) sum -= level.z * log_normal(eta);
    if (level.z < level.n) sum -= (level.n - level.z) * log_normal(-eta);
  }
  return sum;
}

void its_gradient(const gsl_vector* line, void* levels, gsl_vector* gradient) {
  gsl_vector_set_zero(gradient);
  for (const Level& level : *static_cast<const std::vector<Level>*>(levels)) {
    const double eta = gsl_vector_get(line, 0) + gsl_vector_get(line, 1) * level.u;
    const double slope = level.z * score(eta, true) + (level.n - level.z) * score(eta, false);
    *gsl_vector_ptr(gradient, 0) -= slope;
    *gsl_vector_ptr(gradient, 1) -= slope * level.u;
  }
}

void both(const gsl_vector* line, void* levels, double* value, gsl_vector* gradient) {
  *value = minus_log_likelihood(line, levels);
  its_gradient(line, levels, gradient);
}

/// Returns a and b of the largest likelihood, whose logarithm is a concave function of both.
std::array<double, 2> most_likely_line(std::vector<Level> levels) {
  gsl_multimin_function_fdf problem{minus_log_likelihood, its_gradient, both, 2, &levels};
  const std::unique_ptr<gsl_multimin_fdfminimizer, decltype(&gsl_multimin_fdfminimizer_free)> minimizer(
      gsl_multimin_fdfminimizer_alloc(gsl_multimin_fdfminimizer_vector_bfgs2, 2),
      gsl_multimin_fdfminimizer_free);
  const std::unique_ptr<gsl_vector, decltype(&gsl_vector_free)> start(gsl_vector_calloc(2), gsl_vector_free);
  gsl_vector_set(start.get(), 1, 1);
  gsl_multimin_fdfminimizer_set(minimizer.get(), &problem, start.get(), 0.1, 0.1);
  for (int round = 0; round < 1000; ++round)
    if (gsl_multimin_fdfminimizer_iterate(minimizer.get()) != GSL_SUCCESS ||
        gsl_multimin_test_gradient(minimizer->gradient, 1e-10) == GSL_SUCCESS)
      break;
  std::array<double, 2> line{gsl_vector_get(minimizer->x, 0), gsl_vector_get(minimizer->x, 1)}, step{1, 1};
  for (int round = 0; round < 20 && std::hypot(step[0], step[1]) > 1e-12;
       ++round) {  // Newton: the last digits
    Symmetric curvatures;
    std::array<double, 2> slope{0, 0};
    for (const auto& [u, z, n] : levels) {
      const double eta = line[0] + line[1] * u, by_eta = z * score(eta, true) + (n - z) * score(eta, false);
      curvatures += (z * curvature(eta, true) + (n - z) * curvature(eta, false)) * Symmetric{1, u, u * u};
      slope[0] += by_eta, slope[1] += by_eta * u;
    }
    step = solved(curvatures, slope);
    line[0] += step[0], line[1] += step[1];
  }
  if (!(std::hypot(step[0], step[1]) < 1e-8))
    throw std::runtime_error("the likelihood of a fragility curve was not brought to its maximum");
  return line;
}

/// Returns the covariance of a and b by the jackknife.
Symmetric covariance_of(double a, double b, const std::vector<Level>& levels,
                        const std::vector<std::vector<char>>& outcomes) {
  Symmetric all;
  std::vector<Symmetric> curvatures(outcomes.size());
  std::vector<std::array<double, 2>> scores(outcomes.size(), {0, 0});
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    for (std::size_t j = 0; j < levels.size(); ++j) {
      const double u = levels[j].u, eta = a + b * u;
      const bool overturned = outcomes[i][j] != 0;
      curvatures[i] += curvature(eta, overturned) * Symmetric{1, u, u * u};
      scores[i][0] += score(eta, overturned), scores[i][1] += score(eta, overturned) * u;
    }
  for (const Symmetric& one : curvatures) all += one;
  Symmetric covariance;
  const double n = static_cast<double>(outcomes.size());
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const auto [da, db] = solved(all + -1 * curvatures[i], scores[i]);  // the line without this record
    covariance += (n - 1) / n * Symmetric{da * da, da * db, db * db};
  }
  return covariance;
}

/// Returns why there is no curve. In one variable, the likelihood has a maximum if some outcomes of each kind
/// are on either side of some of the other (M. J. Silvapulle, J. R. Statist. Soc. B 43 (1981) 310-313).
std::optional<NoCurve> why_not(const std::vector<double>& peaks, const std::vector<Level>& levels) {
  using Kind = NoCurve::Kind;
  std::size_t first_over = levels.size(), first_safe = levels.size(), last_safe = 0;
  for (std::size_t j = 0; j < levels.size(); ++j) {
    if (levels[j].z > 0) first_over = std::min(first_over, j);
    if (levels[j].z < levels[j].n) first_safe = std::min(first_safe, j), last_safe = j;
  }
  if (first_over == levels.size()) return NoCurve{Kind::none_overturns, peaks.back()};
  if (first_safe == levels.size()) return NoCurve{Kind::all_overturn, peaks.front()};
  if (levels.size() < 2) return NoCurve{Kind::one_amplitude};
  if (levels.front().n < 2) return NoCurve{Kind::one_record};
  if (first_over > last_safe) return NoCurve{Kind::none_between, peaks[last_safe], peaks[first_over]};
  if (first_over == last_safe) return NoCurve{Kind::one_between, peaks[first_over]};
  double growth = 0;  // of the likelihood, from a share that is the same at all amplitudes
  for (const Level& level : levels)
    for (const Level& other : levels) growth += (level.z - other.z) * (level.u - other.u);
  if (growth > 1e-12 * levels.front().n) return std::nullopt;
  return NoCurve{Kind::share_falls};
}

Estimate about(double value, double wide, const auto& scale) {
  return {scale(value), scale(value - wide), scale(value + wide)};
}

}  // namespace

std::string words_for(const NoCurve& reason) {
  switch (reason.kind) {
    case NoCurve::Kind::none_overturns:
      return fmt::format("none overturns up to {:.6g}", reason.low);
    case NoCurve::Kind::all_overturn:
      return fmt::format("all overturn from {:.6g} on", reason.low);
    case NoCurve::Kind::one_amplitude:
      return "one amplitude makes no curve";
    case NoCurve::Kind::one_record:
      return "one record makes no curve";
    case NoCurve::Kind::none_between:
      return fmt::format("none overturns up to {:.6g} and all do from {:.6g} on: no amplitude lies between",
                         reason.low, reason.high);
    case NoCurve::Kind::one_between:
      return fmt::format("none overturns below {:.6g} and all do above: only one amplitude lies between",
                         reason.low);
    case NoCurve::Kind::share_falls:
      return "the share does not grow with the amplitude";
  }
  return "";
}

double peak_of(const Record& record, Peak peak) {
  double largest = 0, velocity = 0;
  if (peak == Peak::acceleration) {
    for (const double value : record.acceleration) largest = std::max(largest, std::abs(value));
    return largest;
  }
  for (std::size_t i = 0; i + 1 < record.time.size(); ++i) {
    const double step = record.time[i + 1] - record.time[i], from = record.acceleration[i],
                 to = record.acceleration[i + 1];
    if (from * to < 0)  // the velocity turns between the samples
      largest = std::max(largest, std::abs(velocity + from * step * from / (from - to) / 2));
    velocity += (from + to) / 2 * step;
    largest = std::max(largest, std::abs(velocity));
  }
  return largest * standard_gravity;
}

std::vector<char> overturned_at(const Block& block, Model model, const Record& record, Peak peak,
                                const std::vector<double>& peaks) {
  const double own = peak_of(record, peak);
  if (!(own > 0 && std::isfinite(1 / own)))
    throw std::invalid_argument(fmt::format("a record whose peak is {} cannot be scaled", own));
  std::vector<char> all;
  for (const double wanted : peaks) {
    const Response response =
        respond(block, model, record_motion(record, block, wanted / own), {}, {.in_double = true});
    all.push_back(outcome_at_end(block, model, response).code != 0);
  }
  return all;
}

LognormalCurve::LognormalCurve(double intercept, double slope, const LineCovariance& covariance, double reach)
    : intercept_(intercept), slope_(slope), covariance_(covariance), reach_(reach) {}

double LognormalCurve::width(double by_intercept, double by_slope) const {
  return reach_ *
         std::sqrt(by_intercept * by_intercept * covariance_.aa +
                   2 * by_intercept * by_slope * covariance_.ab + by_slope * by_slope * covariance_.bb);
}

Estimate LognormalCurve::median() const {  // ln median = -a/b
  const double value = -intercept_ / slope_;
  return about(value, width(-1 / slope_, -value / slope_), [](double x) { return std::exp(x); });
}

Estimate LognormalCurve::beta() const {  // ln beta = -ln b
  return about(-std::log(slope_), width(0, -1 / slope_), [](double x) { return std::exp(x); });
}

Estimate LognormalCurve::at(double peak) const {
  const double u = std::log(peak);
  return about(intercept_ + slope_ * u, width(1, u), gsl_cdf_ugaussian_P);
}

LognormalFit lognormal_fit(const std::vector<double>& peaks, const std::vector<std::vector<char>>& outcomes) {
  gsl_set_error_handler_off();  // errors are told by status, not by abort
  std::vector<Level> levels;
  const double middle = (std::log(peaks.front()) + std::log(peaks.back())) / 2;
  for (std::size_t j = 0; j < peaks.size(); ++j) {
    levels.push_back({std::log(peaks[j]) - middle, 0, static_cast<int>(outcomes.size())});
    for (const auto& record : outcomes) levels[j].z += record[j] != 0;
  }
  if (const auto why = why_not(peaks, levels)) return {.curve = {}, .why_none = why};
  const auto [a, b] = most_likely_line(levels);
  const auto [aa, ab, bb] = covariance_of(a, b, levels, outcomes);
  return {.curve = LognormalCurve(a - b * middle, b,
                                  {aa - 2 * middle * ab + middle * middle * bb, ab - middle * bb, bb},
                                  gsl_cdf_tdist_Pinv(0.975, static_cast<double>(outcomes.size()) - 1)),
          .why_none = {}};
}

}  // namespace rederive::numerics
