#include <doctest/doctest.h>

#include <derivations/rocking_block/energy.hpp>
#include <derivations/rocking_block/impact.hpp>
#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/sliding.hpp>
#include <tests/identities.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::decide;
using namespace rederive::mechanics;
using namespace rederive::rocking_block;
using namespace rederive::test;
using namespace rederive::rocking_block;
using GiNaC::ex;
using GiNaC::lst;

namespace {

const Side sides[] = {Side::negative, Side::positive};

/// What becomes of an expression in the mirror: left and right exchanged.
ex mirrored(const ex& e) {
  return e.subs(lst{theta == -theta, thetadot == -thetadot, thetaddot == -thetaddot, u_gdot == -u_gdot,
                    u_gddot == -u_gddot},
                GiNaC::subs_options::no_pattern);
}

}  // namespace

TEST_CASE("the centre of mass in polar coordinates is the corner of the rectangle, turned") {
  for (const Side side : sides) {
    const ex across = side == Side::negative ? b : -b;
    const Vector turned = turned_clockwise({across, h}, theta), polar = centre_from_pivot(side);
    CHECK(identical(put_in(turned.right, sides_of_the_block()), polar.right));
    CHECK(identical(put_in(turned.up, sides_of_the_block()), polar.up));
  }
}

TEST_CASE("equation of motion: Lagrange and the moments of all elements agree on both sides") {
  for (const Side side : sides) {
    const ex lagrange = motion_by_lagrange(side).subs(J_o == ex(4) / 3 * m * pow(R, 2));
    CHECK(identical(lagrange, put_in(motion_by_moments(side), sides_of_the_block())));
  }
}

TEST_CASE("kinetic energy: summed over the elements and by König") {
  for (const Side side : sides) {
    const Vector element = turned_clockwise({x, y}, theta);
    const Vector velocity = time_derivative(Vector{u_g, 0} + element, block_rates());
    const ex sum =
        put_in(over_body(dot(velocity, velocity) / 2, block_from_pivot(side)), sides_of_the_block());
    CHECK(identical(sum, kinetic_energy(side).subs(J_o == ex(4) / 3 * m * pow(R, 2))));
  }
}

TEST_CASE("the inertia about either pivot is the same, and exceeds that about the centre by m R²") {
  CHECK(identical(derived("u3b").right, derived("u4").right));
  CHECK(identical(derived("u3b").right - moment_of_inertia_about_centre().right, m * pow(R, 2)));
}

TEST_CASE("free motion with the critical velocity has the energy of a block that stands on its corner") {
  for (const Side side : sides) {
    const ex whole = put_in(energy(side).subs(u_gdot == 0), inertia_and_frequency());
    const ex corner = side == Side::negative ? ex(-alpha) : ex(alpha);
    const ex rate = critical_rate(side).right;
    CHECK(identical(whole.subs(thetadot == rate), whole.subs(lst{theta == corner, thetadot == 0})));
    const double sign = side == Side::negative ? -1 : 1;
    for (const double angle : {-0.2, 0.1, 0.24}) {  // outwards before the corner, inwards beyond it
      CHECK(sign * value(rate, {{"alpha", 0.25}, {"p", 2}, {"theta", sign * angle}}) > 0);
      CHECK(sign * value(rate, {{"alpha", 0.25}, {"p", 2}, {"theta", sign * (0.5 - angle)}}) < 0);
    }
  }
}

TEST_CASE("the impact of free motion has all its energy") {
  for (const Side side : sides) {
    const ex whole = put_in(energy(side).subs(u_gdot == 0), inertia_and_frequency());
    const ex square = impact_rate_squared(side).right;
    CHECK(identical(whole.subs(theta == 0).subs(pow(thetadot, 2) == square), whole));
  }
}

TEST_CASE("the two sides are mirror images: motion, energy, reactions") {
  CHECK(identical(mirrored(angular_acceleration(Side::negative)), -angular_acceleration(Side::positive)));
  CHECK(identical(mirrored(energy(Side::negative)), energy(Side::positive)));
  CHECK(identical(mirrored(horizontal_reaction(Side::negative)), -horizontal_reaction(Side::positive)));
  CHECK(identical(mirrored(vertical_reaction(Side::negative)), vertical_reaction(Side::positive)));
}

TEST_CASE("turning θ round alone does not make (22b) of (22a): the coupling to the ground is odd") {
  const ex turned = energy(Side::negative).subs(lst{theta == -theta, thetadot == -thetadot});
  CHECK(!identical(turned, energy(Side::positive)));
  CHECK(identical(turned.subs(u_gdot == -u_gdot), energy(Side::positive)));
}

TEST_CASE("free motion keeps its energy") {
  for (const Side side : sides)
    CHECK(energy_rate(side).subs(lst{u_gdot == 0, u_gddot == 0}).normal().is_zero());
}

TEST_CASE("the energy changes by the power of the horizontal reaction at the moving ground") {
  for (const Side side : sides) {
    const ex power = m * horizontal_reaction(side) * u_gdot;
    CHECK(identical(energy_rate(side), power.subs(R == 3 * g / (4 * pow(p, 2)))));
  }
}

TEST_CASE("balanced on its corner, the block presses on it with its weight alone") {
  const lst still{thetadot == 0, u_gddot == 0};
  CHECK(horizontal_reaction(Side::positive).subs(still).subs(theta == alpha).is_zero());
  CHECK(identical(vertical_reaction(Side::positive).subs(still).subs(theta == alpha), g));
  CHECK(identical(vertical_reaction(Side::negative).subs(still).subs(theta == -alpha), g));
  CHECK(angular_acceleration(Side::negative).subs(still).subs(theta == -alpha).is_zero());
}

TEST_CASE("the reactions while rocking begin as those of the start") {
  const lst start{theta == 0, thetadot == 0, u_gddot == lambda * a_p};
  const ex demand =
      horizontal_reaction(Side::negative).subs(start) / vertical_reaction(Side::negative).subs(start);
  CHECK(identical(demand.subs(R == 3 * g / (4 * pow(p, 2))), first_friction_demand()));
}

TEST_CASE("no moment about the centre is left over by the reactions while rocking") {
  for (const Side side : sides) {
    const Vector pivot = -1 * centre_from_pivot(side);
    const Vector reaction{m * horizontal_reaction(side), m * vertical_reaction(side)};
    const ex needed = m * pow(R, 2) / 3 * angular_acceleration(side);
    const ex left_over = clockwise_cross(pivot, reaction) - needed;
    CHECK(identical(left_over.subs(R == 3 * g / (4 * pow(p, 2))), 0));
  }
}

TEST_CASE("rocking begins where its first angular acceleration vanishes") {
  const ex just = lambda == g * tan(alpha) / a_p;
  CHECK(identical(first_angular_acceleration().subs(just), 0));
  CHECK(identical(first_friction_demand().subs(just), tan(alpha)));
}

TEST_CASE("restitution: by integration over the body and by the parallel axes") {
  CHECK(identical(momentum_before_impact(), momentum_before_impact_by_centre()));
  CHECK(identical(restitution(), restitution_by_parallel_axes()));
}

TEST_CASE("a needle loses nothing at an impact, a plate does not rock on") {
  CHECK(restitution().subs(alpha == 0).is_equal(1));
  CHECK(value(restitution(), {{"alpha", 1.0}}) < 0);  // sin²α > 2/3
  CHECK(value(restitution(), {{"alpha", std::atan(0.11)}}) == doctest::Approx(0.982).epsilon(1e-4));
}

TEST_CASE("an impact in the middle of the base loses nothing, at the edge it loses what (46) says") {
  const ex e = derived("r16").right;
  CHECK(identical(e.subs(d == 0), restitution()));
  CHECK(identical(e.subs(d == R * sin(alpha)), 1));
}

TEST_CASE("the energy lost at an impact is what the squares of the rates lose") {
  const ex after = thetadot_plus == e * thetadot_minus;
  CHECK(identical(derived("u12b").right.subs(after), derived("35").right));
  CHECK(value(derived("35").right, {{"m", 1}, {"R", 1}, {"thetadot_minus", 1}, {"e", 0.9}}) > 0);
}
