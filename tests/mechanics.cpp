#include <doctest/doctest.h>

#include <derivations/mechanics/linear_motion.hpp>
#include <derivations/mechanics/moment_balance.hpp>

#include "identities.hpp"

using namespace rederive;
using GiNaC::ex;

namespace {

const SymbolExpression& named(std::string_view name) { return paper_symbols()[name]; }

Rates rates() {
  return {{named("theta"), named("thetadot")},
          {named("thetadot"), named("thetaddot")},
          {named("u_g"), named("u_gdot")},
          {named("u_gdot"), named("u_gddot")}};
}

}  // namespace

TEST_CASE("a time derivative obeys the chain and product rules, and constants have none") {
  const ex theta = named("theta"), thetadot = named("thetadot"), thetaddot = named("thetaddot"),
           R = named("R");
  CHECK(identical(time_derivative(R * sin(theta), rates()), R * cos(theta) * thetadot));
  CHECK(identical(time_derivative(theta * thetadot, rates()), pow(thetadot, 2) + theta * thetaddot));
  CHECK(time_derivative(pow(R, 3), rates()).is_zero());
}

TEST_CASE("Lagrange gives the equation of the pendulum") {
  const ex m = named("m"), R = named("R"), g = named("g"), theta = named("theta"),
           thetadot = named("thetadot");
  const ex kinetic = m * pow(R * thetadot, 2) / 2, potential = -m * g * R * cos(theta);
  const Coordinate angle{named("theta"), named("thetadot"), named("thetaddot")};
  const ex motion = lagrange_terms(kinetic, potential, angle, rates()).sum();
  CHECK(identical(motion, m * pow(R, 2) * named("thetaddot") + m * g * R * sin(theta)));
  CHECK_THROWS_AS(lagrange_terms(kinetic, potential * thetadot, angle, rates()), std::invalid_argument);
}

TEST_CASE("a clockwise quarter turn takes up to the right, and the cross product counts it positive") {
  const Vector up{0, 1}, right = turned_clockwise(up, GiNaC::Pi / 2);
  CHECK(right.right.is_equal(1));
  CHECK(right.up.is_zero());
  CHECK(clockwise_cross(up, right).is_equal(1));
  CHECK(clockwise_cross(right, up).is_equal(-1));
}

TEST_CASE("a turn keeps lengths") {
  const Vector turned = turned_clockwise({named("b"), named("h")}, named("theta"));
  CHECK(identical(dot(turned, turned), pow(named("b"), 2) + pow(named("h"), 2)));
}

TEST_CASE("a rectangle has its mass, its centre and its moments of inertia") {
  const ex b = named("b"), h = named("h"), m = named("m");
  const Rectangle body{named("x"), named("y"), 0, 2 * b, 0, 2 * h, m / (4 * b * h)};
  CHECK(identical(over_body(1, body), m));
  CHECK(identical(over_body(named("x"), body), m * b));
  CHECK(identical(over_body(named("y"), body), m * h));
  CHECK(identical(over_body(pow(named("x") - b, 2) + pow(named("y") - h, 2), body), m * (b * b + h * h) / 3));
  CHECK_THROWS_AS(over_body(sin(named("x")), body), std::invalid_argument);
}

TEST_CASE("a pendulum on an accelerated support: the moments of all elements and Lagrange agree") {
  const ex b = named("b"), h = named("h"), m = named("m"), g = named("g"), theta = named("theta");
  const Rectangle bar{named("x"), named("y"),     -b, b, -2 * h,
                      0,          m / (4 * b * h)};  // hung at the middle of its top
  const Vector element = turned_clockwise({named("x"), named("y")}, theta);
  const Vector centre = turned_clockwise({0, -h}, theta), support{named("u_g"), 0};
  const ex by_moments = moment_balance(bar, element, support, {{centre, {0, -m * g}}}, rates());
  const Vector velocity = time_derivative(support + element, rates());
  const ex kinetic = over_body(dot(velocity, velocity) / 2, bar), potential = m * g * centre.up;
  const Coordinate angle{named("theta"), named("thetadot"), named("thetaddot")};
  CHECK(identical(lagrange_terms(kinetic, potential, angle, rates()).sum(), -by_moments));
}

TEST_CASE("a body in free fall that does not turn needs no moment, whatever it is seen from") {
  const ex b = named("b"), h = named("h"), m = named("m"), g = named("g");
  const Rectangle body{named("x"), named("y"), 0, b, 0, h, m / (b * h)};
  const Rates falling{{named("y_c"), named("y_cdot")}, {named("y_cdot"), -g}};
  const ex sum = moment_balance(body, {named("x"), named("y")}, {0, named("y_c")},
                                {{{b / 2, h / 2}, {0, -m * g}}}, falling);
  CHECK(sum.is_zero());
}

TEST_CASE("Taylor polynomials keep the stated order, in all small symbols together") {
  const SymbolExpression a = named("alpha"), t = named("theta");
  CHECK(identical(taylor(sin(a + t), {a, t}, 1), a + t));
  CHECK(identical(taylor(sin(a + t), {a, t}, 3), a + t - pow(a + t, 3) / 6));
  CHECK(identical(taylor(a * cos(t), {a, t}, 2), a));
}

TEST_CASE("a particular solution satisfies its equation, for constants, sines and cosines together") {
  const SymbolExpression t = named("t"), p = named("p"), w = named("omega_p"), psi = named("psi"),
                         g = named("g");
  for (const ex& forcing : {ex(g), ex(sin(w * t + psi)), ex(3 * cos(w * t)),
                            ex(g + sin(w * t + psi) - 2 * cos(2 * w * t)), ex(0)}) {
    const ex found = particular_solution({p, forcing, t});
    CHECK(identical(found.diff(t, 2) - pow(p, 2) * found, forcing));
  }
}

TEST_CASE("what undetermined coefficients cannot do is refused") {
  const SymbolExpression t = named("t"), p = named("p");
  CHECK_THROWS_AS(particular_solution({p, t * t, t}), std::invalid_argument);
  CHECK_THROWS_AS(particular_solution({p, sin(t * t), t}), std::invalid_argument);
  CHECK_THROWS_AS(particular_solution({p, t * sin(p * t), t}), std::invalid_argument);
}

TEST_CASE("a solution leaves its start with the angle and the rate it was given") {
  const SymbolExpression t = named("t"), p = named("p"), w = named("omega_p"), t_i = named("t_i");
  const LinearEquation equation{p, named("g") * sin(w * t + named("psi")) + named("alpha"), t};
  const ex motion = solution_from(equation, t_i, named("theta_i"), named("thetadot_i"));
  CHECK(identical(motion.subs(t == t_i), named("theta_i")));
  CHECK(identical(motion.diff(t).subs(t == t_i), named("thetadot_i")));
  CHECK(identical(motion.diff(t, 2) - pow(p, 2) * motion, equation.forcing));
}
