// Where a function of one number changes its sign, and where it is least: GSL's methods. What a function
// throws goes through.
#pragma once

#include <functional>
#include <vector>

namespace rederive::numerics {

using RealFunction = std::function<double(double)>;

/// Two numbers, neighbours or close together, between which something changes.
struct Change {
  double inside, outside;
};

/// Returns two neighbouring numbers, found by bisection: at the first one `holds` is as at the argument
/// `inside`, at the second one as at `outside`. Throws std::invalid_argument if it is the same at both
/// arguments.
Change change_between(const std::function<bool(double)>& holds, double inside, double outside);

/// Returns the root, to the last bits, of a continuous f with different signs at `low` and `high`: R. P.
/// Brent, Algorithms for Minimization without Derivatives (1973), chapter 4. Throws std::invalid_argument if
/// the signs are the same.
double root_between(const RealFunction& f, double low, double high);

/// Returns where f, which first falls and then rises, is least, as exactly as its values allow: Brent,
/// chapter 5.
double least_between(const RealFunction& f, double low, double high);

/// Returns the changes of sign of f from `low` to `high`, in order, each with `inside` below `outside`. It
/// finds changes between `count` points, and dips of |f| that pass through zero between two points.
std::vector<Change> sign_changes(const RealFunction& f, double low, double high, int count);

}  // namespace rederive::numerics
