#include <gsl/gsl_errno.h>
#include <gsl/gsl_min.h>
#include <gsl/gsl_roots.h>

#include <cmath>
#include <exception>
#include <limits>
#include <memory>
#include <numeric>
#include <numerics/search/roots.hpp>
#include <stdexcept>
#include <utility>

namespace rederive::numerics {
namespace {

constexpr double resolution = 4 * std::numeric_limits<double>::epsilon();
constexpr int most_steps = 2000;

/// A function as GSL calls it. An exception must not pass through C: it is kept here, and the function
/// returns NaN, at which GSL stops.
struct Called {
  explicit Called(const RealFunction& f) : f(f) {
    gsl_set_error_handler_off();
  }  // errors by status, not by abort

  static double value(double x, void* self) {
    Called& called = *static_cast<Called*>(self);
    try {
      return called.f(x);
    } catch (...) {
      called.error = std::current_exception();
      return std::numeric_limits<double>::quiet_NaN();
    }
  }
  /// Returns whether GSL could go on.
  bool ok(int status) const {
    if (error) std::rethrow_exception(error);
    return status == GSL_SUCCESS;
  }

  const RealFunction& f;
  std::exception_ptr error;
  gsl_function gsl{value, this};
};

/// Returns the bracket that a method leaves when it is `narrow`.
template <class Narrow>
std::pair<double, double> solved(const gsl_root_fsolver_type* method, const RealFunction& f, double low,
                                 double high, Narrow narrow) {
  Called called(f);
  const std::unique_ptr<gsl_root_fsolver, decltype(&gsl_root_fsolver_free)> solver(
      gsl_root_fsolver_alloc(method), gsl_root_fsolver_free);
  if (!called.ok(gsl_root_fsolver_set(solver.get(), &called.gsl, low, high)))
    throw std::invalid_argument("the function has the same sign at both ends of the interval");
  const auto ends = [&] { return std::pair(solver->x_lower, solver->x_upper); };
  for (int i = 0; i < most_steps && !narrow(ends()); ++i)
    if (!called.ok(gsl_root_fsolver_iterate(solver.get()))) break;
  return ends();
}

}  // namespace

Change change_between(const std::function<bool(double)>& holds, double inside, double outside) {
  const auto neighbours = [](const auto& ends) {
    return !(std::nextafter(ends.first, ends.second) < ends.second);
  };
  const auto sign = [&](double x) { return holds(x) ? 1.0 : -1.0; };
  const auto [low, high] = solved(gsl_root_fsolver_bisection, sign, std::min(inside, outside),
                                  std::max(inside, outside), neighbours);
  return inside < outside ? Change{low, high} : Change{high, low};
}

double root_between(const RealFunction& f, double low, double high) {
  const auto narrow = [](const auto& ends) {
    return gsl_root_test_interval(ends.first, ends.second, 0, resolution) == GSL_SUCCESS;
  };
  const auto ends = solved(gsl_root_fsolver_brent, f, low, high, narrow);
  return std::midpoint(ends.first, ends.second);
}

double least_between(const RealFunction& f, double low, double high) {
  Called called(f);
  const double end = f(low) < f(high) ? low : high, at_end = f(end);
  double inside = std::midpoint(low, high);
  for (int i = 0; i < 30 && !(f(inside) < at_end); ++i) inside = std::midpoint(inside, end);
  const std::unique_ptr<gsl_min_fminimizer, decltype(&gsl_min_fminimizer_free)> search(
      gsl_min_fminimizer_alloc(gsl_min_fminimizer_brent), gsl_min_fminimizer_free);
  if (!called.ok(gsl_min_fminimizer_set(search.get(), &called.gsl, inside, low, high))) return inside;
  for (int i = 0; i < 100; ++i) {
    if (!called.ok(gsl_min_fminimizer_iterate(search.get()))) break;
    if (gsl_min_test_interval(search->x_lower, search->x_upper, 0, resolution) == GSL_SUCCESS) break;
  }
  return search->x_minimum;
}

std::vector<Change> sign_changes(const RealFunction& f, double low, double high, int count) {
  std::vector<double> at, value;
  for (int i = 0; i <= count; ++i) {
    at.push_back(std::lerp(low, high, static_cast<double>(i) / count));
    value.push_back(f(at.back()));
  }
  const auto is_negative = [&](double x) { return f(x) < 0; };
  const auto differ = [](double a, double b) { return (a < 0) != (b < 0); };
  std::vector<Change> changes;
  for (std::size_t i = 0; i + 1 < at.size(); ++i) {
    if (differ(value[i], value[i + 1])) {
      changes.push_back(change_between(is_negative, at[i], at[i + 1]));
      continue;
    }
    const bool dips = i > 0 && !differ(value[i - 1], value[i]) &&
                      std::abs(value[i]) <= std::abs(value[i - 1]) &&
                      std::abs(value[i]) < std::abs(value[i + 1]);
    if (!dips) continue;
    const double sign = value[i] < 0 ? -1 : 1;
    const double least = least_between([&](double x) { return sign * f(x); }, at[i - 1], at[i + 1]);
    if (!differ(f(least), value[i])) continue;
    changes.push_back(change_between(is_negative, at[i - 1], least));
    changes.push_back(change_between(is_negative, least, at[i + 1]));
  }
  return changes;
}

}  // namespace rederive::numerics
