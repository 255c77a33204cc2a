#include <cstddef>
#include <derivations/algebra/linear_program.hpp>

namespace rederive {

using cln::cl_RA;

namespace {

constexpr int most_steps = 400;

/// The equations, solved for the basis: a row each, with the sum at its end. Columns past `real` are made up:
/// with one for each row there is a solution to begin with.
class Tableau {
 public:
  explicit Tableau(const LinearProgram& program)
      : real_(program.columns.size()), width_(real_ + program.sum.size()) {
    for (std::size_t row = 0; row < program.sum.size(); ++row) {
      const cl_RA sign = cln::minusp(program.sum[row]) ? -1 : 1;
      std::vector<cl_RA> entries(width_ + 1, 0);
      for (std::size_t k = 0; k < real_; ++k) entries[k] = sign * program.columns[k][row];
      entries[real_ + row] = 1, entries[width_] = sign * program.sum[row];
      rows_.push_back(std::move(entries));
      basis_.push_back(real_ + row);
    }
  }

  /// Whether the gain is as large as it can be; only the first columns may take part.
  bool maximize(const std::vector<cl_RA>& gains, std::size_t columns) {
    std::vector<cl_RA> left = gains;  // what one more of a column would gain
    left.resize(width_ + 1, 0);
    for (std::size_t row = 0; row < rows_.size(); ++row)
      if (const cl_RA gain = left[basis_[row]]; !cln::zerop(gain)) subtract(left, gain, rows_[row]);
    for (; steps_ < most_steps; ++steps_) {
      std::size_t entering = 0;
      while (entering < columns && !cln::plusp(left[entering])) ++entering;
      if (entering == columns) return true;
      const auto row = leaving(entering);
      if (!row) return true;  // without bound
      pivot(*row, entering);
      const cl_RA gain = left[entering];
      subtract(left, gain, rows_[*row]);
    }
    return false;
  }

  bool has_solution() const {
    for (std::size_t row = 0; row < rows_.size(); ++row)
      if (basis_[row] >= real_ && !cln::zerop(rows_[row][width_])) return false;
    return true;
  }

  std::vector<cl_RA> solution() const {
    std::vector<cl_RA> result(real_, 0);
    for (std::size_t row = 0; row < rows_.size(); ++row)
      if (basis_[row] < real_) result[basis_[row]] = rows_[row][width_];
    return result;
  }

 private:
  static void subtract(std::vector<cl_RA>& from, const cl_RA& factor, const std::vector<cl_RA>& row) {
    for (std::size_t k = 0; k < row.size(); ++k)
      if (!cln::zerop(row[k])) from[k] = from[k] - factor * row[k];
  }

  /// The row that stays within bounds: the smallest quotient, and of equals the first in the basis. What was
  /// made up and is 0 goes first, whatever the sign: it must not grow again.
  std::optional<std::size_t> leaving(std::size_t entering) const {
    std::optional<std::size_t> best;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      const auto& entries = rows_[row];
      if (basis_[row] >= real_ && cln::zerop(entries[width_]) && !cln::zerop(entries[entering])) return row;
      if (!cln::plusp(entries[entering])) continue;
      const auto quotient = [&](std::size_t r) { return rows_[r][width_] / rows_[r][entering]; };
      if (!best || quotient(row) < quotient(*best) ||
          (quotient(row) == quotient(*best) && basis_[row] < basis_[*best]))
        best = row;
    }
    return best;
  }

  void pivot(std::size_t row, std::size_t entering) {
    const cl_RA divisor = rows_[row][entering];
    for (cl_RA& entry : rows_[row]) entry = entry / divisor;
    for (std::size_t other = 0; other < rows_.size(); ++other)
      if (const cl_RA factor = rows_[other][entering]; other != row && !cln::zerop(factor))
        subtract(rows_[other], factor, rows_[row]);
    basis_[row] = entering;
  }

  std::size_t real_, width_;
  std::vector<std::vector<cl_RA>> rows_;
  std::vector<std::size_t> basis_;
  int steps_ = 0;
};

}  // namespace

std::optional<std::vector<cl_RA>> largest_solution(const LinearProgram& program) {
  Tableau tableau(program);
  std::vector<cl_RA> nothing_made_up(program.columns.size(), 0);
  nothing_made_up.resize(program.columns.size() + program.sum.size(), -1);
  if (!tableau.maximize(nothing_made_up, program.columns.size()) || !tableau.has_solution())
    return std::nullopt;
  tableau.maximize(program.gains, program.columns.size());
  return tableau.solution();
}

}  // namespace rederive
