// Linear equations with a solution of which no part is negative.
#pragma once

#include <cln/rational.h>

#include <optional>
#include <vector>

namespace rederive {

/// x_k >= 0 with sum_k x_k columns[k] = sum, exactly; all columns are as long as the sum. GLPK's simplex
/// method, in doubles, says which columns a solution is made of; the exact solution with these is taken where
/// no part of it is negative. So there may be one where nothing is found.
std::optional<std::vector<cln::cl_RA>> nonnegative_solution(
    const std::vector<std::vector<cln::cl_RA>>& columns, const std::vector<cln::cl_RA>& sum);

}  // namespace rederive
