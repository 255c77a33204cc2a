#include <cln/float.h>
#include <cln/real.h>
#include <flint/fmpq_mat.h>
#include <glpk.h>

#include <derivations/numbers/integer.hpp>
#include <derivations/sign/certificate.hpp>
#include <memory>

namespace rederive {

using cln::cl_RA;

namespace {

constexpr int most_steps = 2000;

/// Returns the independent columns in the basis of a solution, in order. Columns whose value is 0 in doubles
/// may take up rounding errors. Returns nothing if doubles find no solution.
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

/// A matrix of rational numbers of FLINT that frees its memory.
struct Matrix {
  Matrix(std::size_t rows, std::size_t columns) { fmpq_mat_init(m, rows, columns); }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;
  ~Matrix() { fmpq_mat_clear(m); }
  void set(std::size_t row, std::size_t column, const cl_RA& q) {
    fmpq_set_fmpz_frac(fmpq_mat_entry(m, row, column), Integer(cln::numerator(q)).z,
                       Integer(cln::denominator(q)).z);
  }
  cl_RA first_of(std::size_t row) const {
    Integer above, below;
    fmpz_set(above.z, fmpq_mat_entry_num(m, row, 0)), fmpz_set(below.z, fmpq_mat_entry_den(m, row, 0));
    return cl_RA(above.value()) / below.value();
  }
  fmpq_mat_t m;
};

}  // namespace

std::optional<std::vector<cl_RA>> nonnegative_solution(const std::vector<std::vector<cl_RA>>& columns,
                                                       const std::vector<cl_RA>& sum) {
  const auto basis = basis_of(columns, sum);
  if (!basis) return std::nullopt;
  Matrix equations(sum.size(), basis->size()), right(sum.size(), 1), solution(basis->size(), 1);
  for (std::size_t row = 0; row < sum.size(); ++row) {
    for (std::size_t k = 0; k < basis->size(); ++k) equations.set(row, k, columns[(*basis)[k]][row]);
    right.set(row, 0, sum[row]);
  }
  if (fmpq_mat_can_solve(solution.m, equations.m, right.m) == 0) return std::nullopt;
  std::vector<cl_RA> result(columns.size(), 0);
  for (std::size_t k = 0; k < basis->size(); ++k) {
    result[(*basis)[k]] = solution.first_of(k);
    if (cln::minusp(result[(*basis)[k]])) return std::nullopt;
  }
  return result;
}

}  // namespace rederive
