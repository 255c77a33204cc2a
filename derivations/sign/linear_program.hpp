// Linear equations with a solution of which no part is negative: the simplex method, and exact numbers.
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

/// The parts of a solution, one for each column, exactly. Which columns it is made of is found with doubles,
/// so that there may be a solution where nothing is found, and the gain is the largest one but for rounding;
/// or, of one without bound or found only after some hundred steps, that of a solution which was met.
/// Dantzig's method with Bland's rule, which never goes round in a circle.
std::optional<std::vector<cln::cl_RA>> largest_solution(const LinearProgram& program);

}  // namespace rederive
