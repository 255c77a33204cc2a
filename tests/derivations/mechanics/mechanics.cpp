#include <doctest/doctest.h>

#include <derivations/mechanics/linear_motion.hpp>
#include <derivations/mechanics/plane.hpp>
#include <tests/identities.hpp>

using namespace rederive::numbers;
using namespace rederive::mechanics;
using namespace rederive::rocking_block;
using namespace rederive::test;
using namespace rederive::rocking_block;
using GiNaC::ex;

namespace {

Rates rates() { return {{theta, thetadot}, {thetadot, thetaddot}, {u_g, u_gdot}, {u_gdot, u_gddot}}; }

}  // namespace

TEST_CASE("a time derivative obeys the chain and product rules, and constants have none") {
  CHECK(identical(time_derivative(R * sin(theta), rates()), R * cos(theta) * thetadot));
  CHECK(identical(time_derivative(theta * thetadot, rates()), pow(thetadot, 2) + theta * thetaddot));
  CHECK(time_derivative(pow(R, 3), rates()).is_zero());
}

TEST_CASE("Lagrange gives the equation of the pendulum") {
  const ex kinetic = m * pow(R * thetadot, 2) / 2, potential = -m * g * R * cos(theta);
  const Coordinate angle{theta, thetadot, thetaddot};
  const ex motion = lagrange_terms(kinetic, potential, angle, rates()).sum();
  CHECK(identical(motion, m * pow(R, 2) * thetaddot + m * g * R * sin(theta)));
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
  const Vector turned = turned_clockwise({b, h}, theta);
  CHECK(identical(dot(turned, turned), pow(b, 2) + pow(h, 2)));
}

TEST_CASE("a rectangle has its mass, its centre and its moments of inertia") {
  const Rectangle body{x, y, 0, 2 * b, 0, 2 * h, m / (4 * b * h)};
  CHECK(identical(over_body(1, body), m));
  CHECK(identical(over_body(x, body), m * b));
  CHECK(identical(over_body(y, body), m * h));
  CHECK(identical(over_body(pow(x - b, 2) + pow(y - h, 2), body), m * (b * b + h * h) / 3));
  CHECK_THROWS_AS(over_body(sin(x), body), std::invalid_argument);
}

TEST_CASE("a pendulum on an accelerated support: the moments of all elements and Lagrange agree") {
  const Rectangle bar{x, y, -b, b, -2 * h, 0, m / (4 * b * h)};  // hung at the middle of its top
  const Vector element = turned_clockwise({x, y}, theta);
  const Vector centre = turned_clockwise({0, -h}, theta), support{u_g, 0};
  const ex by_moments = moment_balance(bar, element, support, {{centre, {0, -m * g}}}, rates());
  const Vector velocity = time_derivative(support + element, rates());
  const ex kinetic = over_body(dot(velocity, velocity) / 2, bar), potential = m * g * centre.up;
  const Coordinate angle{theta, thetadot, thetaddot};
  CHECK(identical(lagrange_terms(kinetic, potential, angle, rates()).sum(), -by_moments));
}

TEST_CASE("a body in free fall that does not turn needs no moment, whatever it is seen from") {
  const Rectangle body{x, y, 0, b, 0, h, m / (b * h)};
  const Rates falling{{y_c, y_cdot}, {y_cdot, -g}};
  const ex sum = moment_balance(body, {x, y}, {0, y_c}, {{{b / 2, h / 2}, {0, -m * g}}}, falling);
  CHECK(sum.is_zero());
}

TEST_CASE("Taylor polynomials keep the stated order, in all small symbols together") {
  const ex sum = alpha + theta;
  CHECK(identical(taylor(sin(sum), {alpha, theta}, 1), sum));
  CHECK(identical(taylor(sin(sum), {alpha, theta}, 3), sum - pow(sum, 3) / 6));
  CHECK(identical(taylor(alpha * cos(theta), {alpha, theta}, 2), alpha));
}

TEST_CASE("a particular solution satisfies its equation, for constants, sines and cosines together") {
  const ex phase = omega_p * t;
  for (const ex& forcing : {ex(g), ex(sin(phase + psi)), ex(3 * cos(phase)),
                            ex(g + sin(phase + psi) - 2 * cos(2 * phase)), ex(0)}) {
    const ex found = particular_solution({p, forcing, t});
    CHECK(identical(found.diff(t, 2) - pow(p, 2) * found, forcing));
  }
}

TEST_CASE("what undetermined coefficients cannot do is refused") {
  CHECK_THROWS_AS(particular_solution({p, t * t, t}), std::invalid_argument);
  CHECK_THROWS_AS(particular_solution({p, sin(t * t), t}), std::invalid_argument);
  CHECK_THROWS_AS(particular_solution({p, t * sin(p * t), t}), std::invalid_argument);
}

TEST_CASE("a solution leaves its start with the angle and the rate it was given") {
  const LinearEquation equation{p, g * sin(omega_p * t + psi) + alpha, t};
  const ex motion = solution_from(equation, t_i, theta_i, thetadot_i);
  CHECK(identical(motion.subs(t == t_i), theta_i));
  CHECK(identical(motion.diff(t).subs(t == t_i), thetadot_i));
  CHECK(identical(motion.diff(t, 2) - pow(p, 2) * motion, equation.forcing));
}
