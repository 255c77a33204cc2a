#include <algorithm>
#include <derivations/mechanics/small_motion.hpp>
#include <stdexcept>

namespace rederive::mechanics {
using namespace language;

using GiNaC::ex;
using GiNaC::ex_to;
using GiNaC::is_a;
using GiNaC::matrix;
using GiNaC::symbol;

LinearSystem linearised(const std::vector<ex>& equations, const std::vector<Coordinate>& coordinates,
                        const std::vector<Given>& state) {
  const auto n = static_cast<unsigned>(coordinates.size());
  if (equations.size() != n)
    throw std::invalid_argument("linearised: " + std::to_string(equations.size()) + " equations for " +
                                std::to_string(n) + " coordinates");
  GiNaC::exmap at;
  for (const Coordinate& q : coordinates) at[q.position] = at[q.rate] = at[q.second_rate] = 0;
  for (const Given& given : state) at[given.name] = given.value;
  const auto there = [&](const ex& e) { return simplified(e.subs(at, GiNaC::subs_options::no_pattern)); };
  LinearSystem system{matrix(n, n), matrix(n, n), matrix(n, n), {}, {}};
  for (unsigned i = 0; i < n; ++i) {
    system.residual.push_back(there(equations[i]));
    ex sum = system.residual[i];
    for (unsigned k = 0; k < n; ++k) {
      const Coordinate& q = coordinates[k];
      system.mass(i, k) = there(equations[i].diff(q.second_rate));
      system.damping(i, k) = there(equations[i].diff(q.rate));
      system.stiffness(i, k) = there(equations[i].diff(q.position));
      sum += system.mass(i, k) * q.second_rate + system.damping(i, k) * q.rate +
             system.stiffness(i, k) * q.position;
    }
    system.steps.push_back({"To first order in the deviations from the state,", sum, 0});
  }
  return system;
}

namespace {

void check_matrix(const matrix& a, const char* name) {
  const std::string its_name = std::string("modes_of: the matrix of the ") + name;
  if (a.rows() != a.cols() || a.rows() < 1 || a.rows() > 3)
    throw std::invalid_argument(its_name + " must have one, two or three rows and as many columns");
  for (unsigned i = 0; i < a.rows(); ++i)
    for (unsigned k = 0; k < i; ++k)
      if (!vanishes(a(i, k) - a(k, i))) throw std::invalid_argument(its_name + " must be symmetric");
}

/// Returns the conditions under which the determinants of the upper left corners are positive.
std::vector<Step> positive_definite(const matrix& mass, const Relations& known) {
  std::vector<Step> conditions;
  for (unsigned n = 1; n <= mass.rows(); ++n) {
    const ex corner = simplified(ex_to<matrix>(GiNaC::sub_matrix(mass, 0, n, 0, n)).determinant());
    const auto its_sign = sign(corner, known);
    if (its_sign && *its_sign <= 0)
      throw std::invalid_argument("modes_of: the matrix of the mass must be positive definite");
    if (!its_sign) conditions.push_back({"provided that", corner, 0, ">"});
  }
  return conditions;
}

/// Returns the roots of a polynomial of degree 1 to 3 whose roots are real, the least first if the leading
/// coefficient is positive.
std::vector<ex> real_roots(const ex& polynomial, const ex& x, const Relations& known) {
  const int degree = polynomial.degree(x);
  const auto c = [&](int n) { return polynomial.coeff(x, n); };
  if (degree == 1) return {simplified(-c(0) / c(1))};
  if (degree == 2) {
    const ex half = root_of(pow(c(1), 2) - 4 * c(2) * c(0), known), middle = -c(1);
    return {(middle - half) / (2 * c(2)), (middle + half) / (2 * c(2))};
  }
  // x = y + shift makes it y³ + p y + q = 0, and y = 2 √(−p/3) cos φ makes that 4 cos³φ − 3 cos φ = cos 3φ.
  const ex shift = -c(2) / (3 * c(3));
  const ex monic = (polynomial / c(3)).subs(x == x + shift).expand();
  const ex p = simplified(monic.coeff(x, 1)), q = simplified(monic.coeff(x, 0));
  const ex radius = root_of(-p / 3, known), phase = acos(simplified(3 * q / (2 * p)) / radius) / 3;
  std::vector<ex> roots;
  for (int k = 2; k >= 0; --k) roots.push_back(2 * radius * cos(phase - 2 * k * GiNaC::Pi / 3) + shift);
  return roots;
}

/// Returns the common sign of all roots of a polynomial with real roots, by Descartes' rule, or nothing.
std::optional<int> sign_of_roots(const ex& polynomial, const ex& x, const Relations& known) {
  if (polynomial.degree(x) == 1) return sign(-polynomial.coeff(x, 0) / polynomial.coeff(x, 1), known);
  bool are_equal = true, do_alternate = true;
  for (int n = 1; n <= polynomial.degree(x); ++n) {
    const auto ratio = sign(polynomial.coeff(x, n) / polynomial.coeff(x, n - 1), known);
    are_equal = are_equal && ratio == 1;
    do_alternate = do_alternate && ratio == -1;
  }
  return are_equal ? std::optional(-1) : do_alternate ? std::optional(1) : std::nullopt;
}

}  // namespace

Modes modes_of(const matrix& mass, const matrix& stiffness, const SymbolExpression& lambda,
               const Relations& known) {
  check_matrix(mass, "mass");
  check_matrix(stiffness, "stiffness");
  if (mass.rows() != stiffness.rows()) throw std::invalid_argument("modes_of: the matrices differ in size");
  Modes result;
  result.conditions = positive_definite(mass, known);
  const matrix pencil = stiffness.sub(mass.mul_scalar(lambda));
  result.polynomial = simplified(pencil.determinant()).collect(lambda);
  result.steps.push_back(
      {"The determinant of K − ω² M vanishes, with the square λ of the frequency:", result.polynomial, 0});
  for (const ex& factor : factors_of(simplified(result.polynomial).numer())) {
    ex polynomial = (is_a<GiNaC::power>(factor) ? factor.op(0) : factor).expand();
    const int degree = polynomial.degree(lambda);
    if (degree == 0) continue;
    if (sign(polynomial.coeff(lambda, degree), known) == -1) polynomial = -polynomial;
    const ex leading = polynomial.coeff(lambda, degree), others = polynomial - leading * pow(lambda, degree);
    const auto its_sign = sign_of_roots(polynomial, lambda, known);
    // The shapes are found in terms of λ, whose powers from this degree on are lower powers.
    Relations with_root = known;
    with_root.push_back(pow(lambda, degree) == -others.expand() / leading);
    std::vector<Step> pivots;
    const auto shapes = null_space(pencil, with_root, pivots);
    for (const ex& root : real_roots(polynomial, lambda, known)) {
      const auto at_root = [&](const ex& e) { return simplified(e.subs(lambda == root)); };
      result.steps.push_back({"so that the square of a frequency is", lambda, root});
      if (!its_sign) result.conditions.push_back({"provided that", root, 0, ">="});
      for (const Step& pivot : pivots)
        add_conditions(result.conditions, not_zero(at_root(pivot.left), known));
      for (std::vector<ex> shape : shapes) {
        std::ranges::transform(shape, shape.begin(), at_root);
        const auto is_greater = [&](const Mode& other) { return sign(other.square - root, known) == 1; };
        const std::optional<ex> frequency =
            its_sign == -1 ? std::nullopt : std::optional(root_of(root, known));
        result.modes.insert(std::ranges::find_if(result.modes, is_greater), {root, frequency, shape});
        for (std::size_t k = 0; k < shape.size(); ++k)
          result.steps.push_back({k == 0 ? "and its mode has the components" : "and",
                                  symbol("v_" + std::to_string(k + 1)), shape[k]});
      }
    }
  }
  return result;
}

}  // namespace rederive::mechanics
