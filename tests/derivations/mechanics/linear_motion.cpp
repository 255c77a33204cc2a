// Linear equations of motion: every solution is put back into its equation and its conditions.
#include <doctest/doctest.h>

#include <derivations/mechanics/linear_motion.hpp>
#include <tests/derivations/mechanics/letters.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::test;
using GiNaC::ex;

namespace {

const SymbolExpression t = letter("t", "(-inf, inf)"), m = letter("m"), c = letter("c"), k = letter("k"),
                       delta = letter("delta"), omega = letter("omega"), Omega = letter("Omega"),
                       zeta = letter("zeta"), p = letter("p"), F = letter("F"),
                       q_0 = letter("q_0", "(-inf, inf)"), v_0 = letter("v_0", "(-inf, inf)"),
                       psi = letter("psi", "(-inf, inf)"), a = letter("a", "(-inf, inf)"), L = letter("L"),
                       C = letter("C", "(-inf, inf)"), D = letter("D", "(-inf, inf)");

ex left_side(const LinearEquation& e, const ex& q) {
  return e.mass * q.diff(t, 2) + e.damping * q.diff(t) + e.stiffness * q;
}

/// Returns the motion from q_0 and v_0 at t = 0, which is proved to be one under the assumptions.
Motion checked(const LinearEquation& equation, const std::vector<std::string>& assumptions = {}) {
  const Motion motion = solution(equation, from_start(0, q_0, v_0));
  CHECK(same(left_side(equation, motion.value), equation.forcing, assumptions));
  CHECK(same(motion.value.subs(t == 0), q_0, assumptions));
  CHECK(same(motion.value.diff(t).subs(t == 0), v_0, assumptions));
  REQUIRE_FALSE(motion.steps.empty());
  CHECK(motion.steps.back().right.is_equal(motion.value));
  return motion;
}

}  // namespace

TEST_CASE("Taylor polynomials keep the stated order, in all small symbols together") {
  const SymbolExpression x = letter("x", "(-inf, inf)"), y = letter("y", "(-inf, inf)");
  CHECK(same(taylor(sin(x + y), {x, y}, 1), x + y));
  CHECK(same(taylor(sin(x + y), {x, y}, 3), x + y - pow(x + y, 3) / 6));
  CHECK(same(taylor(x * cos(y), {x, y}, 2), x));
}

TEST_CASE("the oscillator swings, its reverse departs, and without stiffness a body drifts") {
  CHECK(same(checked({m, 0, k, 0, t}).value,
             q_0 * cos(sqrt(k / m) * t) + v_0 * sqrt(m / k) * sin(sqrt(k / m) * t)));
  CHECK(same(checked({1, 0, -p * p, 0, t}).value, q_0 * cosh(p * t) + v_0 / p * sinh(p * t)));
  CHECK(same(checked({m, 0, 0, 0, t}).value, q_0 + v_0 * t));
  CHECK(same(checked({m, c, 0, 0, t}).value, q_0 + m * v_0 / c * (1 - exp(-c / m * t))));
}

TEST_CASE("damping: three cases, by a declared relation") {
  const LinearEquation equation{1, 2 * zeta * omega, omega * omega, 0, t};
  const auto with = [&](const ex& relation) {
    LinearEquation known = equation;
    known.known = {relation};
    return known;
  };
  const ex damped = omega * sqrt(1 - zeta * zeta);
  CHECK(same(checked(with(zeta < 1), {"zeta < 1"}).value,
             exp(-zeta * omega * t) *
                 (q_0 * cos(damped * t) + (v_0 + zeta * omega * q_0) / damped * sin(damped * t)),
             {"zeta < 1"}));
  const ex rate = omega * sqrt(zeta * zeta - 1);
  CHECK(same(
      checked(with(zeta > 1), {"zeta > 1"}).value,
      exp(-zeta * omega * t) * (q_0 * cosh(rate * t) + (v_0 + zeta * omega * q_0) / rate * sinh(rate * t)),
      {"zeta > 1"}));
  const Motion critical = checked(with(zeta == 1), {"zeta = 1"});
  CHECK(same(critical.value, exp(-omega * t) * (q_0 + (v_0 + omega * q_0) * t), {"zeta = 1"}));
  CHECK(critical.conditions.empty());
  CHECK(checked({1, 2, 1, 0, t}).value.is_equal(solution({1, 2, 1, 0, t}, from_start(0, q_0, v_0)).value));
  CHECK_THROWS_WITH_AS(roots_of(equation),
                       "roots_of: the sign of the discriminant 4*omega^2*zeta^2 - 4*omega^2 is not known; "
                       "declare a relation or choose the roots",
                       std::invalid_argument);
}

TEST_CASE("damping: three cases, by the choice of the caller, who is told what it means") {
  LinearEquation equation{m, c, k, 0, t};
  equation.roots = Roots::complex;
  CHECK(formulas(checked(equation, {"c^2 < 4*k*m"}).conditions) == "c^2 - 4*m*k < 0");
  equation.roots = Roots::real;
  CHECK(formulas(checked(equation, {"c^2 > 4*k*m"}).conditions) == "c^2 - 4*m*k > 0");
  equation.roots = Roots::equal;
  CHECK(formulas(checked(equation, {"c = 2*sqrt(k*m)"}).conditions) == "c^2 - 4*m*k = 0");
  equation = {1, 0, k, 0, t};
  equation.roots = Roots::real;
  CHECK_THROWS_WITH_AS(roots_of(equation),
                       "roots_of: the discriminant -4*k does not have the sign of the chosen roots",
                       std::invalid_argument);
}

TEST_CASE("numbers decide the case, also negative damping") {
  CHECK(roots_of({1, 2, 5, 0, t}) == Roots::complex);
  CHECK(roots_of({1, 2, 1, 0, t}) == Roots::equal);
  CHECK(roots_of({1, 3, 2, 0, t}) == Roots::real);
  checked({1, -2, 5, 0, t});
  checked({1, 3, 2, 0, t});
  checked({2, -3, -2, 0, t});
  checked({-1, 0, -4, 0, t});
}

TEST_CASE("forcing of every kind, for the three kinds of equations") {
  const std::vector<ex> forcings{F,
                                 a * t + F,
                                 pow(t, 3) - 2 * t,
                                 sin(2 * t + psi),
                                 F * cos(3 * t) - sin(2 * t),
                                 exp(-t / 2),
                                 t * exp(t / 3),
                                 t * t * sin(2 * t),
                                 exp(-3 * t) * cos(t),
                                 sinh(3 * t) + cosh(t / 4),
                                 3 + t * cos(4 * t) * exp(t),
                                 exp(2 - t / 5) + exp(-t / 5)};
  for (const ex& forcing : forcings)
    for (const LinearEquation& equation : {LinearEquation{1, 0, 7, 0, t},
                                           {1, 0, -5, 0, t},
                                           {2, 3, 1, 0, t},
                                           {1, 2, 1, 0, t},
                                           {1, 2, 5, 0, t},
                                           {0, 2, 7, 0, t},
                                           {1, 3, 0, 0, t}}) {
      LinearEquation forced = equation;
      forced.forcing = forcing;
      CAPTURE(printed(forcing));
      const Motion found = particular_solution(forced);
      CHECK(same(left_side(forced, found.value), forcing));
      CHECK(found.conditions.empty());
    }
}

TEST_CASE("resonance multiplies by the time") {
  const Motion swing = particular_solution({m, 0, m * omega * omega, F * cos(omega * t), t});
  CHECK(same(swing.value, F / (2 * m * omega) * t * sin(omega * t)));
  CHECK(swing.conditions.empty());
  CHECK(same(particular_solution({1, 0, -p * p, exp(p * t), t}).value, t * exp(p * t) / (2 * p)));
  CHECK(same(particular_solution({1, 2 * p, p * p, exp(-p * t), t}).value, t * t * exp(-p * t) / 2));
  CHECK(same(particular_solution({m, 0, 0, F, t}).value, F / (2 * m) * t * t));
  CHECK(same(particular_solution({m, c, 0, F, t}).value, F / c * t));
  CHECK(same(particular_solution({0, 1, p, exp(-p * t), t}).value, t * exp(-p * t)));
  const std::vector<LinearEquation> resonant{{1, 0, 4, t * sin(2 * t) + cos(2 * t + psi), t},
                                             {1, 2, 5, exp(-t) * cos(2 * t), t},
                                             {1, 2, 1, t * exp(-t), t},
                                             {1, 0, -9, sinh(3 * t) + t * exp(-3 * t), t},
                                             {m, 0, k, cos(sqrt(k / m) * t), t}};
  for (const LinearEquation& equation : resonant)
    CHECK(same(left_side(equation, particular_solution(equation).value), equation.forcing));
}

TEST_CASE("where resonance is possible its absence is a condition; damping excludes it") {
  const Motion undamped = checked({1, 0, omega * omega, F * sin(Omega * t), t});
  CHECK(formulas(undamped.conditions) == "Omega - omega != 0");
  LinearEquation apart{1, 0, omega * omega, F * sin(Omega * t), t};
  apart.known = {Omega < omega};
  CHECK(checked(apart).conditions.empty());
  const LinearEquation damped{m, c, k, F * sin(Omega * t), t};
  const Motion steady = particular_solution(damped);
  CHECK(steady.conditions.empty());
  CHECK(same(left_side(damped, steady.value), damped.forcing));
  const ex size = pow(k - m * Omega * Omega, 2) + pow(c * Omega, 2);
  const ex sine = steady.value.expand().coeff(sin(Omega * t)),
           cosine = steady.value.expand().coeff(cos(Omega * t));
  CHECK(same(sine * sine + cosine * cosine, F * F / size));
}

TEST_CASE("an equation of first order") {
  const Motion cooling = solution({0, c, k, F, t}, {{0, q_0}});
  CHECK(same(cooling.value, F / k + (q_0 - F / k) * exp(-k / c * t)));
  CHECK(cooling.conditions.empty());
  const Motion driven = solution({0, 1, p, sin(omega * t), t}, {{a, q_0}});
  CHECK(same(driven.value.subs(t == a), q_0));
  CHECK(same(driven.value.diff(t) + p * driven.value, sin(omega * t)));
  CHECK(formulas(solution({0, a, k, 0, t}, {{0, q_0}}).conditions) == "a != 0");
}

TEST_CASE("boundary values; a pivot that may vanish is a condition") {
  const LinearEquation string{1, 0, k * k, F, t};
  const Motion between = solution(string, {{0, 0}, {L, q_0}});
  CHECK(same(left_side(string, between.value), F));
  CHECK(same(between.value.subs(t == 0), 0));
  CHECK(same(between.value.subs(t == L), q_0));
  CHECK(formulas(between.conditions) == "sin(k*L) != 0");
  const LinearEquation beam{1, 0, -k * k, F * t, t};
  const Motion tied = solution(beam, {{0, 0}, {L, v_0, 1}});
  CHECK(same(left_side(beam, tied.value), F * t));
  CHECK(same(tied.value.subs(t == 0), 0));
  CHECK(same(tied.value.diff(t).subs(t == L), v_0));
  CHECK(tied.conditions.empty());
}

TEST_CASE("conditions that contradict each other, or leave the motion open, are refused") {
  const LinearEquation oscillator{1, 0, 1, 0, t};
  CHECK_THROWS_WITH_AS(solution(oscillator, {{0, 0}, {GiNaC::Pi, 1}}), doctest::Contains("contradict"),
                       std::invalid_argument);
  CHECK_THROWS_WITH_AS(solution(oscillator, {{0, 0}, {GiNaC::Pi, 0}}),
                       doctest::Contains("does not determine"), std::invalid_argument);
  CHECK_THROWS_WITH_AS(solution(oscillator, {{0, 0}}),
                       "solution: an equation of order 2 needs as many conditions, not 1",
                       std::invalid_argument);
  CHECK_THROWS_WITH_AS(solution({0, 0, k, 0, t}, {{0, 0}}),
                       "general_solution: the equation has no derivative", std::invalid_argument);
}

TEST_CASE("what undetermined coefficients cannot do is refused") {
  for (const ex& forcing :
       std::vector<ex>{sin(t * t), 1 / ex(t), tan(t), exp(sin(t)), pow(sin(t), 2), sqrt(ex(t))}) {
    CAPTURE(printed(forcing));
    CHECK_THROWS_WITH_AS(particular_solution({1, 0, 1, forcing, t}),
                         doctest::Contains("no ansatz for the term"), std::invalid_argument);
  }
}

TEST_CASE("the general solution has its constants, counted from its start") {
  const LinearEquation equation{1, 2, 5, F, t};
  const ex motion = general_solution(equation, a, C, D).value;
  CHECK(same(motion, exp(-(t - a)) * (C * sin(2 * (t - a)) + D * cos(2 * (t - a))) + F / 5));
  const Constants found = solution(equation, from_start(a, q_0, v_0)).constants;
  CHECK(same(found.D, q_0 - F / 5));
  CHECK(same(found.C, (v_0 + q_0 - F / 5) / 2));
}

TEST_CASE("the steps tell the method: characteristic polynomial, ansatz, coefficients, constants") {
  LinearEquation equation{1, 0, 4, 8, t};
  equation.quantity = letter("x", "(-inf, inf)");
  const Motion motion = solution(equation, from_start(0, 0, 0));
  CHECK(formulas(motion.steps) ==
        "-16 < 0; x = C*sin(2*t) + D*cos(2*t); x = a_1; a_1 = 2; x = 2; x = 2 + C*sin(2*t) + D*cos(2*t); 0 = "
        "D + 2; 0 = 2*C; C = 0; D = -2; x = 2 - 2*cos(2*t)");
}
