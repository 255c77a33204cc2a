// Linear equations with a solution of which no part is negative: the simplex method, in exact numbers.
#pragma once

#include <cln/rational.h>

#include <optional>
#include <vector>

namespace rederive {

/// What is to be found: x_k >= 0 with sum_k x_k columns[k] = sum, and of these one with the largest
/// sum_k gains[k] x_k. All columns are as long as the sum; there is one gain for each column.
struct LinearProgram {
  std::vector<std::vector<cln::cl_RA>> columns;
  std::vector<cln::cl_RA> sum, gains;
};

/// The parts of a solution, one for each column; nothing if there is none, or if it takes more than a few
/// hundred steps. Where the gain has no largest value, the solution is one of those that were met.
/// Dantzig's method with Bland's rule, which never goes round in a circle.
std::optional<std::vector<cln::cl_RA>> largest_solution(const LinearProgram& program);

}  // namespace rederive
