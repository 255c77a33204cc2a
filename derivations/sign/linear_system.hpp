// Linear equations, solved exactly.
#pragma once

#include <cln/rational.h>

#include <optional>
#include <vector>

namespace rederive {

/// One equation a row, its right-hand side at the end: Σ xₖ row[k] = row.back(). The solution by elimination;
/// nothing where there is none, or more than one.
std::optional<std::vector<cln::cl_RA>> solve(std::vector<std::vector<cln::cl_RA>> rows);

}  // namespace rederive
