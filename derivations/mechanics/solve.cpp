#include <algorithm>
#include <derivations/mechanics/solve.hpp>
#include <stdexcept>

namespace rederive::mechanics {
using namespace language;

using GiNaC::ex;
using GiNaC::is_a;

namespace {

/// A matrix on the way to its reduced form.
class Elimination {
 public:
  /// Reduces the first `columns` columns of a.
  Elimination(GiNaC::matrix matrix, unsigned columns, const Relations& known)
      : a(std::move(matrix)), known_(known), columns_(columns) {}

  GiNaC::matrix a;
  std::vector<std::pair<unsigned, unsigned>> pivots;  ///< rows and columns

  /// Returns the place of the next pivot, or nothing if all entries left are 0.
  std::optional<std::pair<unsigned, unsigned>> next() const {
    std::optional<std::pair<unsigned, unsigned>> best;
    int least = 3;
    for (unsigned column = 0; column < columns_; ++column)
      for (unsigned row = 0; row < a.rows(); ++row) {
        if (is_used(row) || vanishes(a(row, column), known_)) continue;
        const int doubt = is_a<GiNaC::numeric>(a(row, column)) ? 0 : sign(a(row, column), known_) ? 1 : 2;
        if (doubt >= least) continue;
        best = {row, column};
        least = doubt;
      }
    return best;
  }

  /// Makes this entry 1 and the others of its column 0.
  void reduce(unsigned row, unsigned column) {
    pivots.emplace_back(row, column);
    const ex pivot = a(row, column);
    for (unsigned k = 0; k < a.cols(); ++k) a(row, k) = simplified(a(row, k) / pivot);
    for (unsigned other = 0; other < a.rows(); ++other) {
      const ex factor = a(other, column);
      if (other == row || factor.is_zero()) continue;
      for (unsigned k = 0; k < a.cols(); ++k) a(other, k) = simplified(a(other, k) - factor * a(row, k));
    }
  }

  bool is_used(unsigned row) const {
    return std::ranges::any_of(pivots, [&](const auto& pivot) { return pivot.first == row; });
  }

 private:
  const Relations known_;
  unsigned columns_;
};

/// A linear system: the coefficients of the unknowns, and what they add up to in the last column.
GiNaC::matrix matrix_of(const std::vector<ex>& equations, const std::vector<SymbolExpression>& unknowns) {
  const auto n = static_cast<unsigned>(unknowns.size());
  GiNaC::matrix matrix(static_cast<unsigned>(equations.size()), n + 1);
  GiNaC::exmap none;
  for (const SymbolExpression& unknown : unknowns) none[unknown] = 0;
  for (unsigned row = 0; row < matrix.rows(); ++row) {
    const ex& equation = equations[row];
    const std::string name = "solve: equation " + std::to_string(row + 1);
    if (is_a<GiNaC::relational>(equation) && !equation.info(GiNaC::info_flags::relation_equal))
      throw std::invalid_argument(name + " must be an equation or an expression that is 0");
    const ex left = (is_a<GiNaC::relational>(equation) ? equation.lhs() - equation.rhs() : equation).expand();
    for (unsigned column = 0; column < n; ++column) {
      matrix(row, column) = left.diff(unknowns[column]).expand();
      for (const SymbolExpression& other : unknowns)
        if (matrix(row, column).has(other))
          throw std::invalid_argument(name + ", " + text_of(left) + " = 0, is not linear in " +
                                      text_of(other));
    }
    matrix(row, n) = -left.subs(none, GiNaC::subs_options::no_pattern);
  }
  return matrix;
}

}  // namespace

ex Solution::in(const ex& e) const {
  GiNaC::exmap map;
  for (const Given& given : values) map[given.name] = given.value;
  return e.subs(map, GiNaC::subs_options::no_pattern);
}

void add_conditions(std::vector<Step>& conditions, const std::vector<Step>& more) {
  for (const Step& condition : more) {
    const auto is_same = [&](const Step& other) {
      return other.relation == condition.relation && vanishes(other.left - condition.left);
    };
    if (std::ranges::none_of(conditions, is_same)) conditions.push_back(condition);
  }
}

std::vector<Step> not_zero(const ex& e, const Relations& known) {
  std::vector<Step> conditions;
  for (const ex& factor : factors_that_may_vanish(e, known))
    conditions.push_back({"provided that", factor, 0, "!="});
  return conditions;
}

Solution solve(const std::vector<ex>& equations, const std::vector<SymbolExpression>& unknowns,
               const Relations& known) {
  const auto n = static_cast<unsigned>(unknowns.size());
  Elimination system(matrix_of(equations, unknowns), n, known);
  Solution solution;
  while (const auto pivot = system.next()) {
    const auto [row, column] = *pivot;
    add_conditions(solution.conditions, not_zero(system.a(row, column), known));
    system.reduce(row, column);
    ex value = system.a(row, n);
    for (unsigned k = 0; k < n; ++k)
      if (k != column) value -= system.a(row, k) * unknowns[k];
    const std::string place = "quation " + std::to_string(row + 1) + " gives";
    solution.steps.push_back(
        {(system.pivots.size() == 1 ? "E" : "with this, e") + place, unknowns[column], value});
  }
  for (unsigned row = 0; row < system.a.rows(); ++row)
    if (!system.is_used(row) && !vanishes(system.a(row, n), known))
      throw std::invalid_argument("solve: the equations contradict each other: they need " +
                                  text_of(simplified(system.a(row, n)).numer()) + " = 0");
  for (unsigned column = 0; column < n; ++column) {
    const auto pivot = std::ranges::find(system.pivots, column, &std::pair<unsigned, unsigned>::second);
    if (pivot == system.pivots.end())
      throw std::invalid_argument("solve: the system is singular: it does not determine " +
                                  text_of(unknowns[column]));
    solution.values.push_back({unknowns[column], system.a(pivot->first, n)});
  }
  const std::vector<Step> pivots = solution.steps;
  for (const auto& [name, value] : solution.values) {
    const auto is_known = [&name = name, &value = value](const Step& step) {
      return step.left.is_equal(name) && step.right.is_equal(value);
    };
    if (std::ranges::none_of(pivots, is_known)) solution.steps.push_back({"so that", name, value});
  }
  return solution;
}

std::vector<std::vector<ex>> null_space(const GiNaC::matrix& a, const Relations& known,
                                        std::vector<Step>& conditions) {
  Elimination system(a, a.cols(), known);
  while (const auto pivot = system.next()) {
    add_conditions(conditions, not_zero(system.a(pivot->first, pivot->second), known));
    system.reduce(pivot->first, pivot->second);
  }
  std::vector<std::vector<ex>> basis;
  for (unsigned free = 0; free < a.cols(); ++free) {
    if (std::ranges::count(system.pivots, free, &std::pair<unsigned, unsigned>::second) > 0) continue;
    std::vector<ex> vector(a.cols(), 0);
    vector[free] = 1;
    for (const auto& [row, column] : system.pivots) vector[column] = -system.a(row, free);
    const ex first =
        *std::ranges::find_if_not(vector, [](const ex& component) { return vanishes(component); });
    for (ex& component : vector) component = simplified(component / first);
    basis.push_back(vector);
  }
  return basis;
}

}  // namespace rederive::mechanics
