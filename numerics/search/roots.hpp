// Where a function of one number changes its sign, and where it is least: GSL's methods. What a function
// throws goes through.
#pragma once

#include <functional>
#include <vector>

namespace rederive::numerics {

using RealFunction = std::function<double(double)>;

/// Bisects to two neighbouring numbers: at `inside` `holds` is as at the first end, at `outside` as at the
/// other. Throws std::invalid_argument if it is the same at both ends.
struct Change {
  double inside, outside;
};
Change change_between(const std::function<bool(double)>& holds, double inside, double outside);

/// The root, to the last bits, of a continuous f that has different signs at two arguments: Brent, Algorithms
/// for Minimization without Derivatives (1973), chapter 4. Throws std::invalid_argument if the signs are the
/// same.
double root_between(const RealFunction& f, double low, double high);

/// Where an f that first falls and then rises is least, as exactly as its values tell: Brent, chapter 5.
double least_between(const RealFunction& f, double low, double high);

/// The changes of sign from `low` to `high`, in order, each with `inside` below: those between `count`
/// points, and those of dips of |f| that pass through zero in between.
std::vector<Change> sign_changes(const RealFunction& f, double low, double high, int count);

}  // namespace rederive::numerics
