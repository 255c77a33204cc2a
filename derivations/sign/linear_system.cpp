#include <algorithm>
#include <derivations/sign/linear_system.hpp>

namespace rederive {

using cln::cl_RA;

std::optional<std::vector<cl_RA>> solve(std::vector<std::vector<cl_RA>> rows) {
  const std::size_t unknowns = rows.empty() ? 0 : rows[0].size() - 1;
  for (std::size_t k = 0; k < unknowns; ++k) {  // row k gets the pivot of column k
    const auto from = rows.begin() + static_cast<std::ptrdiff_t>(std::min(k, rows.size()));
    const auto pivot = std::find_if(from, rows.end(), [&](const auto& row) { return !cln::zerop(row[k]); });
    if (pivot == rows.end()) return std::nullopt;
    std::swap(*pivot, rows[k]);
    for (std::size_t other = 0; other < rows.size(); ++other) {
      if (other == k || cln::zerop(rows[other][k])) continue;
      const cl_RA factor = rows[other][k] / rows[k][k];
      for (std::size_t j = k; j <= unknowns; ++j)
        if (!cln::zerop(rows[k][j])) rows[other][j] = rows[other][j] - factor * rows[k][j];
    }
  }
  std::vector<cl_RA> x;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    if (row < unknowns)
      x.push_back(rows[row][unknowns] / rows[row][row]);
    else if (!cln::zerop(rows[row][unknowns]))
      return std::nullopt;
  }
  return x;
}

}  // namespace rederive
