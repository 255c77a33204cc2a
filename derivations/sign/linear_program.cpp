#include <cln/float.h>
#include <cln/real.h>
#include <glpk.h>

#include <algorithm>
#include <derivations/sign/linear_program.hpp>
#include <memory>

namespace rederive {

using cln::cl_RA;

namespace {

constexpr int most_steps = 2000;

/// The columns in the basis of a solution, in their order: they are independent. Those that are 0 in doubles
/// may take up what rounding left. Nothing where doubles find no solution.
std::optional<std::vector<std::size_t>> basis_of(const std::vector<std::vector<cl_RA>>& columns,
                                                 const std::vector<cl_RA>& sum) {
  const std::unique_ptr<glp_prob, decltype(&glp_delete_prob)> program(glp_create_prob(), &glp_delete_prob);
  glp_add_rows(program.get(), static_cast<int>(sum.size())),
      glp_add_cols(program.get(), static_cast<int>(columns.size()));
  for (std::size_t row = 0; row < sum.size(); ++row)
    glp_set_row_bnds(program.get(), static_cast<int>(row) + 1, GLP_FX, cln::double_approx(sum[row]), 0);
  for (std::size_t k = 0; k < columns.size(); ++k) {
    std::vector<int> rows(1);  // GLPK counts from 1
    std::vector<double> entries(1);
    for (std::size_t row = 0; row < sum.size(); ++row)
      if (!cln::zerop(columns[k][row]))
        rows.push_back(static_cast<int>(row) + 1), entries.push_back(cln::double_approx(columns[k][row]));
    glp_set_col_bnds(program.get(), static_cast<int>(k) + 1, GLP_LO, 0, 0);
    glp_set_mat_col(program.get(), static_cast<int>(k) + 1, static_cast<int>(rows.size()) - 1, rows.data(),
                    entries.data());
  }
  glp_smcp settings;
  glp_init_smcp(&settings);
  settings.msg_lev = GLP_MSG_OFF, settings.it_lim = most_steps;
  if (glp_simplex(program.get(), &settings) != 0 || glp_get_status(program.get()) != GLP_OPT)
    return std::nullopt;
  std::vector<std::size_t> basis;
  for (std::size_t k = 0; k < columns.size(); ++k)
    if (glp_get_col_stat(program.get(), static_cast<int>(k) + 1) == GLP_BS) basis.push_back(k);
  return basis;
}

/// One equation a row, its right-hand side at the end: Σ xₖ row[k] = row.back(). The solution by elimination;
/// nothing where there is none, or more than one.
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

}  // namespace

std::optional<std::vector<cl_RA>> nonnegative_solution(const std::vector<std::vector<cl_RA>>& columns,
                                                       const std::vector<cl_RA>& sum) {
  const auto basis = basis_of(columns, sum);
  if (!basis) return std::nullopt;
  std::vector<std::vector<cl_RA>> rows(sum.size());
  for (std::size_t row = 0; row < sum.size(); ++row) {
    for (const std::size_t k : *basis) rows[row].push_back(columns[k][row]);
    rows[row].push_back(sum[row]);
  }
  const auto parts = solve(std::move(rows));
  if (!parts || std::any_of(parts->begin(), parts->end(), [](const cl_RA& x) { return cln::minusp(x); }))
    return std::nullopt;
  std::vector<cl_RA> solution(columns.size(), 0);
  for (std::size_t k = 0; k < basis->size(); ++k) solution[(*basis)[k]] = (*parts)[k];
  return solution;
}

}  // namespace rederive
