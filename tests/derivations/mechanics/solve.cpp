// Linear systems: solutions put back, side conditions, and what is refused.
#include <doctest/doctest.h>

#include <derivations/mechanics/solve.hpp>
#include <tests/derivations/mechanics/letters.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::test;
using GiNaC::ex;

namespace {

const SymbolExpression a = letter("a", "(-inf, inf)"), b = letter("b", "(-inf, inf)"),
                       d = letter("d", "(-inf, inf)"), x = letter("x", "(-inf, inf)"),
                       y = letter("y", "(-inf, inf)"), z = letter("z", "(-inf, inf)"), m = letter("m"),
                       M = letter("M"), g = letter("g"), phi = letter("phi", "(-inf, inf)");

/// Solves the equations and puts the values back in.
Solution checked(const std::vector<ex>& equations, const std::vector<SymbolExpression>& unknowns,
                 const Relations& known = {}) {
  const Solution solution = solve(equations, unknowns, known);
  for (const ex& equation : equations) CHECK(same(solution.in(equation.lhs()), solution.in(equation.rhs())));
  REQUIRE(solution.values.size() == unknowns.size());
  for (const Given& given : solution.values)
    for (const SymbolExpression& unknown : unknowns) CHECK_FALSE(given.value.has(unknown));
  return solution;
}

}  // namespace

TEST_CASE("an equation with numbers needs no condition") {
  const Solution solution = checked({2 * x == 3 * a}, {x});
  CHECK(solution.values[0].value.is_equal(3 * a / 2));
  CHECK(solution.conditions.empty());
  CHECK(formulas(solution.steps) == "x = 3*a/2");
}

TEST_CASE("Atwood's machine: pivots of positive symbols need no condition") {
  const SymbolExpression T = x, acceleration = y;
  const Solution solution =
      checked({M * g - T == M * acceleration, T - m * g == m * acceleration}, {T, acceleration});
  CHECK(same(solution.values[0].value, 2 * m * M * g / (m + M)));
  CHECK(same(solution.values[1].value, (M - m) * g / (m + M)));
  CHECK(solution.conditions.empty());
  CHECK(formulas(solution.steps) == "x = M*g - y*M; y = (M*g - m*g)/(m + M); x = 2*m*M*g/(m + M)");
}

TEST_CASE("pivots that may vanish become side conditions, factor by factor") {
  CHECK(formulas(checked({a * x == b}, {x}).conditions) == "a != 0");
  CHECK(formulas(checked({m * (a * a - b * b) * x == 1}, {x}).conditions) == "a + b != 0; a - b != 0");
  CHECK(checked({(a - b) * x == 1}, {x}, {a > b}).conditions.empty());
  // Cramer's rule needs the determinant alone; a pivot that is a number comes first.
  CHECK(formulas(checked({a * x + y == 1, x - b * y == d}, {x, y}).conditions) == "a*b + 1 != 0");
}

TEST_CASE("a rotation is turned back without a condition") {
  const Solution solution =
      checked({cos(phi) * x - sin(phi) * y == a, sin(phi) * x + cos(phi) * y == b}, {x, y});
  CHECK(same(solution.values[0].value, a * cos(phi) + b * sin(phi)));
  CHECK(same(solution.values[1].value, b * cos(phi) - a * sin(phi)));
}

TEST_CASE("three unknowns, and equations that repeat each other") {
  const Solution solution = checked({x + y + z == a, x - y == b, m * z == d, 2 * x + z == a + b}, {x, y, z});
  CHECK(same(solution.values[0].value, (a + b - d / m) / 2));
  CHECK(solution.conditions.empty());
}

TEST_CASE("an expression stands for an equation with 0, and expansion may make it linear") {
  CHECK(solve({pow(x + 1, 2) - pow(x, 2) - a}, {x}).values[0].value.is_equal((a - 1) / 2));
}

TEST_CASE("no unknowns: equations are checked alone") {
  CHECK(solve({}, {}).values.empty());
  CHECK(solve({a == a}, {}).values.empty());
}

TEST_CASE("what cannot be solved is refused, each in its own words") {
  CHECK_THROWS_WITH_AS(solve({x == 1, x * y == a}, {x, y}),
                       "solve: equation 2, x*y - a = 0, is not linear in y", std::invalid_argument);
  CHECK_THROWS_WITH_AS(solve({sin(x) == a}, {x}), "solve: equation 1, sin(x) - a = 0, is not linear in x",
                       std::invalid_argument);
  CHECK_THROWS_WITH_AS(solve({x + y == a, 2 * x + 2 * y == 2 * a}, {x, y}),
                       "solve: the system is singular: it does not determine y", std::invalid_argument);
  CHECK_THROWS_WITH_AS(solve({x == a}, {x, y}), "solve: the system is singular: it does not determine y",
                       std::invalid_argument);
  CHECK_THROWS_WITH_AS(solve({x + y == 1, x + y == 2}, {x, y}),
                       "solve: the equations contradict each other: they need 1 = 0", std::invalid_argument);
  CHECK_THROWS_WITH_AS(solve({x == a, x == b}, {x}),
                       "solve: the equations contradict each other: they need b - a = 0",
                       std::invalid_argument);
  CHECK_THROWS_WITH_AS(solve({x < a}, {x}),
                       "solve: equation 1 must be an equation or an expression that is 0",
                       std::invalid_argument);
}

TEST_CASE("equations that agree under a declared relation do not contradict each other") {
  CHECK(solve({x == a, x == b}, {x}, {a == b}).values[0].value.is_equal(a));
}
