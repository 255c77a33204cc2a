// Linearisation about states, and normal modes, against textbooks and put back into their equations.
#include <doctest/doctest.h>

#include <derivations/mechanics/small_motion.hpp>
#include <tests/derivations/mechanics/letters.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::test;
using GiNaC::ex;
using GiNaC::matrix;

namespace {

SymbolExpression real(const std::string& name) { return letter(name, "(-inf, inf)"); }

const SymbolExpression m = letter("m"), M = letter("M"), k = letter("k"), K = letter("K"), g = letter("g"),
                       L = letter("L"), omega = letter("omega"), lambda = real("lambda"), a = real("a"),
                       theta_e = real("theta_e");
const Coordinate first{real("x"), real("xdot"), real("xddot")},
    second{real("y"), real("ydot"), real("yddot")};

/// Returns the modes, each of which is proved to satisfy (K − λ M) v = 0.
Modes checked(const matrix& mass, const matrix& stiffness, const Relations& known = {}) {
  const Modes result = modes_of(mass, stiffness, lambda, known);
  CHECK(result.modes.size() == mass.rows());
  for (const Mode& mode : result.modes) {
    CHECK(same(result.polynomial.subs(lambda == mode.square), 0));
    for (unsigned i = 0; i < mass.rows(); ++i) {
      ex sum = 0;
      for (unsigned j = 0; j < mass.rows(); ++j)
        sum += (stiffness(i, j) - mode.square * mass(i, j)) * mode.shape[j];
      CHECK(same(sum, 0));
    }
    if (mode.frequency) CHECK(same(pow(*mode.frequency, 2), mode.square));
  }
  return result;
}

/// Returns the value of an expression with 1 for every letter but those that are given.
double value(const ex& e, const GiNaC::exmap& numbers = {}) {
  GiNaC::exmap map = numbers;
  for (const auto& [name, symbol] : letters().table()) map.emplace(symbol, 1);
  return GiNaC::ex_to<GiNaC::numeric>(e.subs(map).evalf()).to_double();
}

}  // namespace

TEST_CASE("a pendulum about its lowest point, its highest, and any other state") {
  const std::vector<ex> pendulum{L * first.second_rate + k * first.rate + g * sin(first.position)};
  const LinearSystem below = linearised(pendulum, {first});
  CHECK(same(below.mass(0, 0), L));
  CHECK(same(below.damping(0, 0), k));
  CHECK(same(below.stiffness(0, 0), g));
  CHECK(below.residual[0].is_zero());
  CHECK(formulas(below.steps) == "k*xdot + g*x + L*xddot = 0");
  CHECK(same(linearised(pendulum, {first}, {{first.position, GiNaC::Pi}}).stiffness(0, 0), -g));
  const LinearSystem leaning =
      linearised(pendulum, {first}, {{first.position, theta_e}, {first.rate, omega}});
  CHECK(same(leaning.stiffness(0, 0), g * cos(theta_e)));
  CHECK(same(leaning.residual[0], g * sin(theta_e) + k * omega));
  CHECK_THROWS_AS(linearised(pendulum, {first, second}), std::invalid_argument);
}

TEST_CASE("a bead on a hoop that turns: about its steady angle") {
  // theta'' = omega² sin(theta) cos(theta) − g/L sin(theta) rests where cos(theta) = g/(L omega²).
  const ex x = first.position;
  const LinearSystem bead = linearised({first.second_rate - omega * omega * sin(x) * cos(x) + g / L * sin(x)},
                                       {first}, {{x, theta_e}});
  const ex there = bead.stiffness(0, 0).subs(g == L * omega * omega * cos(theta_e));
  CHECK(same(there, pow(omega * sin(theta_e), 2)));
  CHECK(same(bead.residual[0].subs(g == L * omega * omega * cos(theta_e)), 0));
}

TEST_CASE("two equal masses between three equal springs") {
  const Modes result = checked(matrix{{m, 0}, {0, m}}, matrix{{2 * k, -k}, {-k, 2 * k}});
  CHECK(same(result.polynomial, (k - m * lambda) * (3 * k - m * lambda)));
  CHECK(same(result.modes[0].square, k / m));
  CHECK(same(*result.modes[1].frequency, sqrt(3 * k / m)));
  CHECK(result.modes[0].shape[1].is_equal(1));
  CHECK(result.modes[1].shape[1].is_equal(-1));
  CHECK(result.conditions.empty());
  CHECK_FALSE(result.steps.empty());
}

TEST_CASE("the double pendulum of equal rods has (2 ± √2) g/L") {
  const Modes result = checked(matrix{{2 * m * L * L, m * L * L}, {m * L * L, m * L * L}},
                               matrix{{2 * m * g * L, 0}, {0, m * g * L}});
  CHECK(same(result.modes[0].square, (2 - sqrt(ex(2))) * g / L));
  CHECK(same(result.modes[1].square, (2 + sqrt(ex(2))) * g / L));
  CHECK(same(result.modes[0].shape[1], sqrt(ex(2))));
  CHECK(same(result.modes[1].shape[1], -sqrt(ex(2))));
}

TEST_CASE("two different masses: the square of each frequency is positive") {
  const Modes result = checked(matrix{{m, 0}, {0, M}}, matrix{{k + K, -K}, {-K, K}});
  CHECK(result.conditions.empty());
  CHECK(value(result.modes[0].square, {{m, 2}, {M, 3}, {k, 5}, {K, 7}}) <
        value(result.modes[1].square, {{m, 2}, {M, 3}, {k, 5}, {K, 7}}));
  CHECK(same(result.modes[0].square * result.modes[1].square, k * K / (m * M)));
  CHECK(same(result.modes[0].square + result.modes[1].square, (k + K) / m + K / M));
}

TEST_CASE("three masses: a free molecule has a frequency 0") {
  const Modes result =
      checked(matrix{{m, 0, 0}, {0, M, 0}, {0, 0, m}}, matrix{{k, -k, 0}, {-k, 2 * k, -k}, {0, -k, k}});
  std::vector<ex> squares;
  for (const Mode& mode : result.modes) squares.push_back(mode.square);
  for (const ex& expected : {ex(0), k / m, k / m + 2 * k / M})
    CHECK(std::ranges::count_if(squares, [&](const ex& square) { return same(square, expected); }) == 1);
  CHECK(result.conditions.empty());
}

TEST_CASE("three equal masses between four equal springs: an irrational pair beside a rational root") {
  const Modes result = checked(matrix{{m, 0, 0}, {0, m, 0}, {0, 0, m}},
                               matrix{{2 * k, -k, 0}, {-k, 2 * k, -k}, {0, -k, 2 * k}});
  CHECK(same(result.modes[0].square + result.modes[1].square + result.modes[2].square, 6 * k / m));
}

TEST_CASE("three equal masses in a row that is fixed at one end: the roots of an irreducible cubic") {
  const matrix mass{{m, 0, 0}, {0, m, 0}, {0, 0, m}}, stiffness{{2 * k, -k, 0}, {-k, 2 * k, -k}, {0, -k, k}};
  const Modes result = modes_of(mass, stiffness, lambda);
  REQUIRE(result.modes.size() == 3);
  for (int n = 0; n < 3; ++n) {  // 2 sin((2n + 1) pi/14)
    const Mode& mode = result.modes[static_cast<std::size_t>(n)];
    const double expected = 2 * std::sin((2 * n + 1) * std::acos(-1.0) / 14);
    CHECK(value(*mode.frequency) == doctest::Approx(expected));
    for (unsigned i = 0; i < 3; ++i) {
      double sum = 0;
      for (unsigned j = 0; j < 3; ++j)
        sum += value(stiffness(i, j) - mode.square * mass(i, j)) * value(mode.shape[j]);
      CHECK(sum == doctest::Approx(0).epsilon(1e-9));
    }
  }
}

TEST_CASE("equal frequencies have as many modes, and one coordinate may be alone") {
  const Modes equal = checked(matrix{{m, 0}, {0, m}}, matrix{{k, 0}, {0, k}});
  CHECK(same(equal.modes[0].square, equal.modes[1].square));
  CHECK_FALSE(equal.modes[0].shape[0].is_equal(equal.modes[1].shape[0]));
  const Modes alone = checked(matrix{{m}}, matrix{{k}});
  CHECK(same(*alone.modes[0].frequency, sqrt(k / m)));
}

TEST_CASE("an unstable state has no frequency; an unknown sign is a condition") {
  const Modes inverted = checked(matrix{{m, 0}, {0, m}}, matrix{{-k, 0}, {0, k}});
  CHECK(std::ranges::count_if(inverted.modes, [](const Mode& mode) { return mode.frequency.has_value(); }) ==
        1);
  CHECK(formulas(modes_of(matrix{{m}}, matrix{{a}}, lambda).conditions) == "a/m >= 0");
  CHECK(modes_of(matrix{{m}}, matrix{{a}}, lambda, {a > 0}).conditions.empty());
  CHECK(formulas(modes_of(matrix{{a}}, matrix{{k}}, lambda).conditions) == "a > 0; k/a >= 0");
}

TEST_CASE("matrices that are not those of a mechanical system are refused") {
  const auto refused = [](const matrix& mass, const matrix& stiffness, const char* why) {
    CHECK_THROWS_WITH_AS(modes_of(mass, stiffness, lambda), doctest::Contains(why), std::invalid_argument);
  };
  refused(matrix{{m, 0}, {0, m}}, matrix{{k, 1}, {0, k}}, "the matrix of the stiffness must be symmetric");
  refused(matrix{{m, m}, {m, m}}, matrix{{k, 0}, {0, k}}, "must be positive definite");
  refused(matrix{{-m}}, matrix{{k}}, "must be positive definite");
  refused(matrix{{m}}, matrix{{k, 0}, {0, k}}, "differ in size");
  refused(matrix(4, 4), matrix(4, 4), "one, two or three rows");
}
