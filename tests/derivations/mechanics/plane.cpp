// Vectors in the plane, polar coordinates, generalised forces and the balance of moments.
#include <doctest/doctest.h>

#include <derivations/mechanics/plane.hpp>
#include <tests/derivations/mechanics/letters.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::test;
using GiNaC::ex;

namespace {

SymbolExpression real(const std::string& name) { return letter(name, "(-inf, inf)"); }

const SymbolExpression m = letter("m"), g = letter("g"), R = letter("R"), b = letter("b"), h = letter("h"),
                       x = real("x"), y = real("y"), y_c = real("y_c"), y_cdot = real("y_cdot"),
                       u_g = real("u_g"), u_gdot = real("u_gdot"), u_gddot = real("u_gddot"), F = real("F"),
                       G = real("G"), C = letter("C");
const Coordinate angle{real("theta"), real("thetadot"), real("thetaddot")};
const Coordinate radius{letter("r"), real("rdot"), real("rddot")};
const ex theta = angle.position;

Rates rates() {
  return {{angle.position, angle.rate}, {angle.rate, angle.second_rate}, {u_g, u_gdot}, {u_gdot, u_gddot}};
}

}  // namespace

TEST_CASE("a clockwise quarter turn takes up to the right, and the cross product counts it positive") {
  const Vector up{0, 1}, right = turned_clockwise(up, GiNaC::Pi / 2);
  CHECK(right.right.is_equal(1));
  CHECK(right.up.is_zero());
  CHECK(clockwise_cross(up, right).is_equal(1));
  CHECK(clockwise_cross(right, up).is_equal(-1));
}

TEST_CASE("a turn keeps lengths") {
  const Vector turned = turned_clockwise({b, h}, theta);
  CHECK(same(dot(turned, turned), pow(b, 2) + pow(h, 2)));
}

TEST_CASE("a pendulum on an accelerated support: the moments of all elements and Lagrange agree") {
  const RigidBody bar = rectangle(x, y, -b, b, -2 * h, 0, m / (4 * b * h));  // hung at the middle of its top
  const Vector element = turned_clockwise({x, y}, theta);
  const Vector centre = turned_clockwise({0, -h}, theta), support{u_g, 0};
  const ex by_moments = moment_balance(bar, element, support, {{centre, {0, -m * g}}}, rates());
  const Vector velocity = time_derivative(support + element, rates());
  const ex kinetic = over_body(dot(velocity, velocity) / 2, bar), potential = m * g * centre.up;
  CHECK(same(lagrange_terms(kinetic, potential, angle, rates()).sum(), -by_moments));
}

TEST_CASE("a body in free fall that does not turn needs no moment, whatever it is seen from") {
  const RigidBody body = rectangle(x, y, 0, b, 0, h, m / (b * h));
  const Rates falling{{y_c, y_cdot}, {y_cdot, -g}};
  const ex sum = moment_balance(body, {x, y}, {0, y_c}, {{{b / 2, h / 2}, {0, -m * g}}}, falling);
  CHECK(sum.is_zero());
}

TEST_CASE("velocity and acceleration in polar coordinates") {
  const PolarMotion motion = polar_motion(radius, angle);
  const ex r = radius.position, rdot = radius.rate, thetadot = angle.rate;
  CHECK(same(motion.velocity.radial, rdot));
  CHECK(same(motion.velocity.transverse, r * thetadot));
  CHECK(same(motion.acceleration.radial, radius.second_rate - r * thetadot * thetadot));
  CHECK(same(motion.acceleration.transverse, r * angle.second_rate + 2 * rdot * thetadot));
  CHECK(formulas({motion.steps.begin(), motion.steps.begin() + 4}) ==
        "v_x = rdot*cos(theta) - thetadot*r*sin(theta); v_y = thetadot*r*cos(theta) + rdot*sin(theta); v_r = "
        "rdot; v_phi = thetadot*r");
  CHECK(motion.steps.size() == 8);
}

TEST_CASE("the generalised force of a turning body is a moment, with the sign of its coordinate") {
  const Vector at = turned_clockwise({0, R}, theta);
  CHECK(same(generalised_force({{at, {F, G}}}, angle), F * R * cos(theta) - G * R * sin(theta)));
  CHECK(same(generalised_force({{at, {F, G}}, {at, {-F, 0}}}, angle), -G * R * sin(theta)));
  CHECK(generalised_force({}, angle).is_zero());
  // The weight as a force gives what the potential gives.
  const ex kinetic = m * pow(R * angle.rate, 2) / 2;
  const ex by_force =
      lagrange_terms(kinetic, 0, angle, rates(), 0, generalised_force({{at, {0, -m * g}}}, angle)).sum();
  CHECK(same(by_force, lagrange_terms(kinetic, m * g * at.up, angle, rates()).sum()));
}
