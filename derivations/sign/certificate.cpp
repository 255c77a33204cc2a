#include <cln/float.h>
#include <cln/real.h>
#include <flint/fmpq_mat.h>
#include <glpk.h>

#include <algorithm>
#include <derivations/numbers/ball.hpp>
#include <derivations/sign/certificate.hpp>
#include <memory>
#include <set>

namespace rederive::sign {
using namespace numbers;
using namespace identity;
using cln::cl_RA;

namespace {
constexpr std::size_t most_columns = 260, most_rows = 240, most_facts = 16;
constexpr int most_steps = 2000;  // of the simplex method

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

/// A product of facts that is positive, not negative, or 0 (then its coefficient may be negative).
struct Column {
  std::vector<Polynomial> factors;
  Polynomial value;  ///< modulo the relations of the ring, times the multiple
  Signs signs;
  cl_RA multiple = 1;
};

/// Returns the number, or a shorter one further out (below it for side +1): products must fit into doubles.
cl_RA shortened(const cl_RA& end, int side) {
  const cl_RA unit = cl_RA(1) / 4096;
  if (cln::integer_length(cln::denominator(end)) < 24) return end;
  return (side > 0 ? cln::floor1(end / unit) : cln::ceiling1(end / unit)) * unit;
}

/// Adds the facts g - low >= 0 and high - g >= 0 of the range of a generator, for rational ends.
void add_range(const Ring& ring, int k, std::vector<Fact>& facts) {
  const Generator& g = ring.generators()[k];
  const Polynomial x = Polynomial::variable(k);
  const auto add = [&](const End& end, int side) {
    if (end.infinite != 0) return;
    const Signs signs = end.closed ? Signs::nonnegative() : Signs::positive();
    Fraction bound(shortened(end.a, side));
    if (!cln::zerop(end.b)) {
      const auto pi = ring.find("pi");
      if (!pi) return;
      bound = bound + Fraction(end.b) * Fraction(Polynomial::variable(*pi));
    }
    facts.push_back({(side * (Fraction(x) - bound)).numerator, signs});
  };
  add(g.range.low, 1), add(g.range.high, -1);
}

/// Returns the facts that share generators with the claim, directly or through others, and their ranges.
std::vector<Fact> relevant(const Ring& ring, const std::vector<Fact>& negated) {
  std::set<int> reached;
  std::vector<Fact> result = negated, others = ring.facts;
  for (const Fact& f : negated)
    for (const int k : f.value.used()) reached.insert(k);
  const auto is_reached = [&](const Fact& f) {
    const auto used = f.value.used();
    const bool shares =
        reached.empty() || std::ranges::any_of(used, [&](int k) { return reached.contains(k); });
    if (!shares || result.size() >= most_facts) return false;
    result.push_back(f), reached.insert(used.begin(), used.end());
    return true;
  };
  while (std::erase_if(others, is_reached) > 0) continue;
  for (const int k : std::set<int>(reached)) add_range(ring, k, result);
  return result;
}

/// Returns the terms of which squares are formed: 1, the generators, and products of two generators.
std::vector<Polynomial> roots_of_squares(const std::set<int>& variables) {
  std::vector<Polynomial> roots{1};
  if (variables.size() > 8) return roots;
  for (const int k : variables) roots.push_back(Polynomial::variable(k));
  for (const int i : variables)
    for (const int j : variables)
      if (variables.size() <= 2 && i <= j) roots.push_back(Polynomial::variable(i) * Polynomial::variable(j));
  return roots;
}

/// Returns products of facts in pairs, squares of generators and differences, equations times generators.
std::vector<Column> columns_of(const Ring& ring, const std::vector<Fact>& facts) {
  std::vector<Column> columns{{{}, 1, Signs::positive()}};
  const auto add = [&](std::vector<Polynomial> factors, Signs signs) {
    Polynomial product = 1;
    for (const Polynomial& f : factors) product = product * f;
    const Fraction value = ring.normal(product);
    const Polynomial& p = value.numerator;
    if (!value.denominator.is_constant() || p.terms() > 40 || (p.is_zero() && signs != Signs::positive()))
      return;
    if (columns.size() < most_columns)
      columns.push_back({std::move(factors), p, signs, value.denominator.constant()});
  };
  std::set<int> variables;
  for (const Fact& f : facts)
    for (const int k : f.value.used()) variables.insert(k);
  for (const Fact& f : facts) add({f.value}, f.signs);
  for (const Fact& f : facts)
    if (f.signs == Signs::zero())
      for (const int k : variables) add({f.value, Polynomial::variable(k)}, f.signs);
  for (std::size_t i = 0; i < facts.size(); ++i)
    for (std::size_t j = i; j < facts.size(); ++j)
      add({facts[i].value, facts[j].value}, facts[i].signs * facts[j].signs);
  const std::vector<Polynomial> roots = roots_of_squares(variables);
  for (std::size_t i = 0; i < roots.size(); ++i) {
    add({roots[i], roots[i]}, Signs::nonnegative());
    for (std::size_t j = 0; j < i; ++j)
      for (const Polynomial& r : {roots[i] - roots[j], roots[i] + roots[j]})
        add({r, r}, Signs::nonnegative());
  }
  return columns;
}

/// Returns coefficients with which the columns add up to 0; those of strict columns add up to 1.
std::optional<Certificate> combine(const std::vector<Column>& columns) {
  std::map<Polynomial, std::size_t> rows;  // of each monomial
  for (const Column& c : columns)
    for (std::size_t t = 0; t < c.value.terms(); ++t) rows.try_emplace(c.value.monomial(t), rows.size());
  if (rows.size() > most_rows) return std::nullopt;
  std::vector<std::vector<cl_RA>> all;
  std::vector<std::pair<std::size_t, cl_RA>> of;  // which column, and times what: no entry is above 1
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (const int side : {1, -1}) {
      if (side < 0 && columns[k].signs != Signs::zero()) continue;
      const Polynomial& p = columns[k].value;
      cln::cl_I largest = 1;
      for (std::size_t t = 0; t < p.terms(); ++t) largest = cln::max(largest, cln::abs(p.coefficient(t)));
      const cl_RA factor = cl_RA(side) / largest;
      std::vector<cl_RA> entries(rows.size() + 1, 0);
      for (std::size_t t = 0; t < p.terms(); ++t) entries[rows.at(p.monomial(t))] = factor * p.coefficient(t);
      entries.back() = columns[k].signs == Signs::positive() ? 1 : 0;
      all.push_back(std::move(entries));
      of.emplace_back(k, factor);
    }
  std::vector<cl_RA> one(rows.size() + 1, 0);
  one.back() = 1;
  const auto solution = nonnegative_solution(all, one);
  if (!solution) return std::nullopt;
  std::vector<Certificate::Part> parts;
  Fraction sum = 0;
  cl_RA strict = 0;
  for (std::size_t k = 0; k < of.size(); ++k) {
    const cl_RA& x = (*solution)[k];
    if (cln::zerop(x)) continue;
    const Column& c = columns[of[k].first];
    parts.push_back({x * of[k].second * c.multiple, c.factors});
    sum = sum + Fraction(x * of[k].second) * Fraction(c.value);
    if (c.signs == Signs::positive()) strict = strict + x;
  }
  const bool holds = sum.is_zero() && cln::plusp(strict);  // multiplied out, not believed
  return holds ? std::optional<Certificate>({{parts}}) : std::nullopt;
}

std::optional<Certificate> refute_all(const Ring& ring, const Fraction& value, Signs negated) {
  const std::vector<Fact> claim = facts_of(ring, value, negated);
  if (claim.empty() && negated != Signs::any()) return std::nullopt;  // of what is not 0
  const std::vector<Fact> all = relevant(ring, claim);
  if (all.empty() || all.size() > 2 * most_facts) return std::nullopt;
  return combine(columns_of(ring, all));
}

}  // namespace

std::vector<Fact> facts_of(const Ring& ring, const Fraction& value, Signs signs) {
  Fact fact = ring.essential(value, signs);
  if (fact.signs.within(Signs::nonpositive()) && fact.signs != Signs::zero())
    fact = {-fact.value, -fact.signs};
  const bool can_be_said = fact.signs.within(Signs::nonnegative()) && !fact.signs.is_none();
  const bool is_known = fact.value.is_constant() && ring.signs_of(fact.value).within(fact.signs);
  return can_be_said && !is_known ? std::vector{fact} : std::vector<Fact>{};
}

std::optional<Certificate> prove_signs(const Ring& ring, const Fraction& value, Signs claim, bool searches) {
  if (!claim.is_none() && ring.signs_of(ring.normal(value)).within(claim)) return Certificate{};
  if (!searches) return std::nullopt;
  if (claim.is_none()) return refute_all(ring, 0, Signs::any());
  if (claim != Signs::zero()) return refute_all(ring, value, ~claim);
  // with the numerator as it is, or without the factors that are not 0
  for (const Fraction& p : {Fraction(ring.essential(value, claim).value), value}) {
    auto found = refute_all(ring, p, Signs::positive());
    const auto other = found ? refute_all(ring, p, Signs::negative()) : std::nullopt;
    if (!other) continue;
    found->sums.push_back(other->sums[0]);
    return found;
  }
  return std::nullopt;
}

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

}  // namespace rederive::sign
