// Integrals over bodies, against the tables of textbooks.
#include <doctest/doctest.h>

#include <derivations/mechanics/body.hpp>
#include <tests/derivations/mechanics/letters.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::test;
using GiNaC::ex;

namespace {

const SymbolExpression x = letter("x", "(-inf, inf)"), y = letter("y", "(-inf, inf)"), m = letter("m"),
                       M = letter("M"), L = letter("L"), R = letter("R"), r = letter("r"), b = letter("b"),
                       h = letter("h"), u = letter("u", "(-inf, inf)"), v = letter("v", "(-inf, inf)"),
                       phi = letter("phi", "(-inf, inf)");

constexpr int along_x = 0, along_z = 2;

/// Returns the moment of inertia of one body about an axis of coordinates through its centre.
ex inertia(const RigidBody& body, int axis = along_z) {
  Position direction{0, 0, 0};
  direction.at(static_cast<std::size_t>(axis)) = 1;
  const MassProperties properties = mass_properties({body}, direction);
  CHECK(same(properties.mass, m));
  return properties.inertia;
}

}  // namespace

TEST_CASE("integrals of polynomials, and of sines and cosines") {
  CHECK(same(integral(x * x + y, x, 0, L), pow(L, 3) / 3 + y * L));
  CHECK(same(integral(pow(cos(phi), 2), phi, 0, 2 * GiNaC::Pi), GiNaC::Pi));
  CHECK(same(integral(pow(sin(phi), 3) * pow(cos(phi), 2), phi, 0, GiNaC::Pi / 2), ex(2) / 15));
  CHECK(same(integral(pow(cos(phi), 4), phi, u, v).diff(v), pow(cos(v), 4)));
  CHECK(same(integral(sin(phi) * cos(phi), phi, u, v).diff(v), sin(v) * cos(v)));
  CHECK_THROWS_AS(integral(exp(x), x, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(integral(x * sin(x), x, 0, 1), std::invalid_argument);
  CHECK_THROWS_AS(integral(1 / ex(x), x, 1, 2), std::invalid_argument);
}

TEST_CASE("the moments of inertia of textbooks") {
  CHECK(same(inertia(rod(m, L)), m * L * L / 12));
  CHECK(same(inertia(rod(m, L), along_x), 0));
  CHECK(same(inertia(disc(m, R)), m * R * R / 2));
  CHECK(same(inertia(disc(m, R), along_x), m * R * R / 4));
  CHECK(same(inertia(ring(m, R)), m * R * R));
  CHECK(same(inertia(ring(m, R), along_x), m * R * R / 2));
  CHECK(same(inertia(ring(m, r, R)), m * (R * R + r * r) / 2));
  CHECK(same(inertia(cylinder(m, R, L)), m * R * R / 2));
  CHECK(same(inertia(cylinder(m, R, L), along_x), m * (3 * R * R + L * L) / 12));
  CHECK(same(inertia(rectangle(x, y, -b, b, -h, h, m / (4 * b * h))), m * (b * b + h * h) / 3));
}

TEST_CASE("a rectangle has its mass, its centre and its moments") {
  const RigidBody body = rectangle(x, y, 0, 2 * b, 0, 2 * h, m / (4 * b * h));
  CHECK(same(over_body(1, body), m));
  CHECK(same(over_body(x, body), m * b));
  CHECK(same(over_body(y, body), m * h));
  CHECK_THROWS_AS(over_body(exp(x), body), std::invalid_argument);
}

TEST_CASE("a body of one's own: the bounds of one parameter contain another") {
  // The triangle with corners (0, 0), (b, 0) and (b, h).
  const RigidBody triangle = homogeneous(m, {x, y, 0}, {{y, 0, h * x / b}, {x, 0, b}});
  const MassProperties properties = mass_properties({triangle});
  CHECK(same(properties.centre[0], 2 * b / 3));
  CHECK(same(properties.centre[1], h / 3));
  CHECK(same(properties.inertia, m * (b * b + h * h) / 18));
  // Half a ring has its centre outside.
  const RigidBody arch = homogeneous(m, {R * cos(phi), R * sin(phi), 0}, {{phi, 0, GiNaC::Pi}});
  CHECK(same(mass_properties({arch}).centre[1], 2 * R / GiNaC::Pi));
}

TEST_CASE("parallel axes: the theorem agrees with integration over the body in its place") {
  const RigidBody bodies[] = {rod(m, L), disc(m, R), ring(m, R), cylinder(m, R, L)};
  for (const RigidBody& body : bodies) {
    const MassProperties at_rest = mass_properties({body});
    const RigidBody elsewhere = placed(body, {u, v, L}, phi);
    const Position& at = elsewhere.element;
    CHECK(same(about_parallel_axis(at_rest, {-u, -v, 0}), at_rest.inertia + m * (u * u + v * v)));
    CHECK(same(over_body(at[0] * at[0] + at[1] * at[1], elsewhere), at_rest.inertia + m * (u * u + v * v)));
    const MassProperties moved = mass_properties({elsewhere});
    CHECK(same(moved.centre[0], u));
    CHECK(same(moved.centre[1], v));
    CHECK(same(moved.inertia, at_rest.inertia));
  }
  CHECK(same(about_parallel_axis(mass_properties({rod(m, L)}), {L / 2, 0, 0}), m * L * L / 3));
}

TEST_CASE("a composite body: its parts are integrated together") {
  const RigidBody stick = placed(rod(m, L), {L / 2, 0, 0}), bob = placed(disc(M, R), {L + R, 0, 0});
  const MassProperties together = mass_properties({stick, bob});
  CHECK(same(together.mass, m + M));
  CHECK(same(together.centre[0], (m * L / 2 + M * (L + R)) / (m + M)));
  CHECK(same(about_parallel_axis(together, {0, 0, 0}), m * L * L / 3 + M * R * R / 2 + M * pow(L + R, 2)));
}

TEST_CASE("a hole is a part of negative mass") {
  // A disc of radius R without the disc of radius R/2 that touches its centre and its edge.
  const MassProperties rest = mass_properties({disc(4 * m, R), placed(disc(-m, R / 2), {R / 2, 0, 0})});
  CHECK(same(rest.mass, 3 * m));
  CHECK(same(rest.centre[0], -R / 6));
  CHECK(same(rest.inertia, 37 * m * R * R / 24));
}

TEST_CASE("steps say what was integrated") {
  CHECK(formulas(mass_properties({rod(m, L)}).steps) == "m = m; x_C = 0; y_C = 0; z_C = 0; J_C = 1/12*m*L^2");
}

TEST_CASE("what has no centre is refused") {
  CHECK_THROWS_WITH_AS(mass_properties({disc(m, R), disc(-m, r)}),
                       "mass_properties: the mass of a body must not be 0", std::invalid_argument);
  CHECK_THROWS_AS(mass_properties({}), std::invalid_argument);
}
