#include <cln/float.h>
#include <cln/real.h>

#include <cstddef>
#include <derivations/sign/linear_program.hpp>
#include <type_traits>

namespace rederive {

using cln::cl_RA;

namespace {

constexpr int most_steps = 400;

/// What the method asks of numbers; a double is 0 within this.
constexpr double rounding = 1e-9;
bool is_positive(const cl_RA& x) { return cln::plusp(x); }
bool is_positive(double x) { return x > rounding; }
bool is_zero(const cl_RA& x) { return cln::zerop(x); }
bool is_zero(double x) { return x < rounding && x > -rounding; }
template <class Number>
Number as(const cl_RA& x) {
  if constexpr (std::is_same_v<Number, double>)
    return cln::double_approx(x);
  else
    return x;
}

/// The equations, solved for the basis: a row each, with the sum at its end. Columns past `real` are made up:
/// with one for each row there is a solution to begin with.
template <class Number>
class Tableau {
 public:
  explicit Tableau(const LinearProgram& program)
      : real_(program.columns.size()), width_(real_ + program.sum.size()) {
    for (std::size_t row = 0; row < program.sum.size(); ++row) {
      const Number sign = cln::minusp(program.sum[row]) ? -1 : 1;
      std::vector<Number> entries(width_ + 1, 0);
      for (std::size_t k = 0; k < real_; ++k) entries[k] = sign * as<Number>(program.columns[k][row]);
      entries[real_ + row] = 1, entries[width_] = sign * as<Number>(program.sum[row]);
      rows_.push_back(std::move(entries));
      basis_.push_back(real_ + row);
    }
  }

  /// First that nothing made up is left, then the gain. Whether there is a solution; the gain is as large as
  /// it can be, or as it was when there were too many steps, or no bound.
  bool solve(const std::vector<cl_RA>& gains) {
    std::vector<Number> nothing_made_up(width_, 0), of_columns;
    for (std::size_t k = real_; k < width_; ++k) nothing_made_up[k] = -1;
    for (const cl_RA& gain : gains) of_columns.push_back(as<Number>(gain));
    if (!maximize(nothing_made_up) || !has_solution()) return false;
    maximize(of_columns);
    return has_solution();
  }

  /// The columns that the solution is made of.
  std::vector<std::size_t> basis() const {
    std::vector<std::size_t> result;
    for (const std::size_t k : basis_)
      if (k < real_) result.push_back(k);
    return result;
  }

  std::vector<Number> solution() const {
    std::vector<Number> result(real_, 0);
    for (std::size_t row = 0; row < rows_.size(); ++row)
      if (basis_[row] < real_) result[basis_[row]] = rows_[row][width_];
    return result;
  }

 private:
  /// As large as it can be, or without bound. False where there were too many steps.
  bool maximize(std::vector<Number> left) {  // what one more of a column would gain
    left.resize(width_ + 1, 0);
    for (std::size_t row = 0; row < rows_.size(); ++row)
      if (const Number gain = left[basis_[row]]; !is_zero(gain)) subtract(left, gain, rows_[row]);
    for (; steps_ < most_steps; ++steps_) {
      std::size_t entering = 0;
      while (entering < real_ && !is_positive(left[entering])) ++entering;
      if (entering == real_) return true;
      const auto row = leaving(entering);
      if (!row) return true;  // without bound
      pivot(*row, entering);
      const Number gain = left[entering];
      subtract(left, gain, rows_[*row]);
    }
    return false;
  }

  bool has_solution() const {
    for (std::size_t row = 0; row < rows_.size(); ++row)
      if (basis_[row] >= real_ && !is_zero(rows_[row][width_])) return false;
    return true;
  }

  static void subtract(std::vector<Number>& from, const Number& factor, const std::vector<Number>& row) {
    for (std::size_t k = 0; k < row.size(); ++k)
      if (!is_zero(row[k])) from[k] = from[k] - factor * row[k];
  }

  /// The row that stays within bounds: the smallest quotient, and of equals the first in the basis. What was
  /// made up and is 0 goes first, whatever the sign: it must not grow again.
  std::optional<std::size_t> leaving(std::size_t entering) const {
    std::optional<std::size_t> best;
    for (std::size_t row = 0; row < rows_.size(); ++row) {
      const auto& entries = rows_[row];
      if (basis_[row] >= real_ && is_zero(entries[width_]) && !is_zero(entries[entering])) return row;
      if (!is_positive(entries[entering])) continue;
      const auto quotient = [&](std::size_t r) { return rows_[r][width_] / rows_[r][entering]; };
      if (!best || quotient(row) < quotient(*best) ||
          (quotient(row) == quotient(*best) && basis_[row] < basis_[*best]))
        best = row;
    }
    return best;
  }

  void pivot(std::size_t row, std::size_t entering) {
    const Number divisor = rows_[row][entering];
    for (Number& entry : rows_[row]) entry = entry / divisor;
    for (std::size_t other = 0; other < rows_.size(); ++other)
      if (const Number factor = rows_[other][entering]; other != row && !is_zero(factor))
        subtract(rows_[other], factor, rows_[row]);
    basis_[row] = entering;
  }

  std::size_t real_, width_;
  std::vector<std::vector<Number>> rows_;
  std::vector<std::size_t> basis_;
  int steps_ = 0;
};

}  // namespace

std::optional<std::vector<cl_RA>> largest_solution(const LinearProgram& program) {
  Tableau<double> rounded(program);
  if (!rounded.solve(program.gains)) return std::nullopt;
  const std::vector<std::size_t> basis = rounded.basis();
  LinearProgram exact{{}, program.sum, {}};
  for (const std::size_t k : basis)
    exact.columns.push_back(program.columns[k]), exact.gains.push_back(program.gains[k]);
  Tableau<cl_RA> tableau(exact);
  if (!tableau.solve(exact.gains)) return std::nullopt;
  std::vector<cl_RA> solution(program.columns.size(), 0);
  const std::vector<cl_RA> parts = tableau.solution();
  for (std::size_t k = 0; k < basis.size(); ++k) solution[basis[k]] = parts[k];
  return solution;
}

}  // namespace rederive
