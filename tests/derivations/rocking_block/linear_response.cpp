#include <doctest/doctest.h>

#include <derivations/rocking_block/initial_conditions.hpp>
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
const Pulse pulses[] = {Pulse::none, Pulse::sine, Pulse::cosine};

double threshold(const ThresholdEquation& equation, double omega_ratio, double low, double high) {
  return root(
      [&](double psi) {
        return value(equation.residual(), {{"psi", psi},
                                           {"omega_p", omega_ratio},
                                           {"p", 1},
                                           {"alpha", 0.25},
                                           {"theta_0", 0},
                                           {"thetadot_0", 0}});
      },
      low, high);
}

}  // namespace

TEST_CASE("every linear motion satisfies its equation and leaves with its initial conditions") {
  for (const Side side : sides)
    for (const Pulse pulse : pulses) {
      const ex motion = linear_response(side, pulse);
      const LinearEquation equation = linear_equation(side, pulse);
      CHECK(identical(motion.diff(t, 2) + equation.stiffness * motion, equation.forcing));
      CHECK(identical(motion.subs(t == 0), theta_0));
      CHECK(identical(motion.diff(t).subs(t == 0), thetadot_0));
    }
}

TEST_CASE("by half phases it is the same motion, and begins without a difference of large terms") {
  for (const Side side : sides) {
    const ex motion = linear_response(side, Pulse::sine), halved = by_half_phases(motion);
    CHECK(identical(motion, halved));
    CHECK(halved.coeff(theta_0, 0)
              .subs(lst{sinh(p * t / 2) == 0, sin(omega_p * t / 2) == 0})
              .expand()
              .is_zero());
  }
}

TEST_CASE("the linear equation is the tangent of the exact one") {
  const SymbolExpression size = rho;  // any symbol that the equation does not have
  for (const Side side : sides) {
    const ex exact = angular_acceleration(side).subs(u_gddot == ground_acceleration(Pulse::sine));
    const LinearEquation linear = linear_equation(side, Pulse::sine);
    const ex difference = (exact + linear.stiffness * theta - linear.forcing)
                              .subs(lst{theta == size * theta, alpha == size * alpha, a_p == size * a_p});
    CHECK(difference.subs(size == 0).is_zero());
    CHECK(difference.diff(size).subs(size == 0).expand().is_zero());
  }
}

TEST_CASE("the amplitude leaves the linear block on the point of moving at t = 0") {
  for (const Pulse pulse : {Pulse::sine, Pulse::cosine}) {
    const Given a = amplitude(pulse);
    CHECK(identical(linear_equation(Side::negative, pulse).forcing.subs(t == 0).subs(a.name == a.value), 0));
  }
}

TEST_CASE("free linear motion keeps p²(θ ± α)² − θ̇²") {
  for (const Side side : sides) {
    const ex motion = free_motion(side), corner = side == Side::negative ? ex(-alpha) : ex(alpha);
    const ex kept = pow(p * (motion - corner), 2) - pow(motion.diff(t), 2);
    CHECK(identical(kept.diff(t), 0));
  }
}

TEST_CASE(
    "free linear motion comes upright with the velocity, and is critical at the rate, that it is said to") {
  for (const Side side : sides) {
    const LinearEquation equation = linear_equation(side, Pulse::none);
    const ex motion = solution(equation, from_start(0, theta_0, thetadot_0)).value;
    const auto along = [&](const ex& e) { return e.subs(lst{theta == motion, thetadot == motion.diff(t)}); };
    const ex square = linear_impact_rate_squared(side);
    CHECK(identical(along(square).diff(t), 0));
    CHECK(identical(square.subs(theta == 0), pow(thetadot, 2)));
    CHECK(identical(
        growing_part(motion.subs(thetadot_0 == linear_critical_rate(side).subs(theta == theta_0)), 0), 0));
  }
}

TEST_CASE("under a line of ground acceleration the linear motion obeys its equation") {
  for (const Side side : sides) {
    const LinearEquation equation = linear_equation_under(side, a_p * (lambda + mu * t));
    const ex motion = solution(equation, from_start(0, theta_0, thetadot_0)).value;
    CHECK(identical(motion.diff(t, 2) + equation.stiffness * motion, equation.forcing));
    CHECK(identical(motion.subs(t == 0), theta_0));
    CHECK(identical(motion.diff(t).subs(t == 0), thetadot_0));
  }
}

TEST_CASE("without its growing part a free motion dies away to the corner") {
  const ex motion = free_motion(Side::positive);
  const ex growing = growing_part(motion, t_o);
  const ex critical = motion.subs(Abar_3 == Abar_3 - 2 * growing);
  CHECK(identical(critical - alpha, Abar_4 * exp(-p * (t - t_o))));
}

TEST_CASE("the pulse has stopped accelerating the ground where it ends") {
  for (const Pulse pulse : {Pulse::sine, Pulse::cosine})
    CHECK(identical(ground_acceleration(pulse).subs(t == end_of_pulse(pulse)), 0));
}

TEST_CASE("(104) without a push is (71), and (103) without one is (78) a quarter of a turn later") {
  const lst rest{theta_0 == 0, thetadot_0 == 0};
  CHECK(identical(overturning_sine_pulse().residual().subs(rest), derived("71").left - derived("71").right));
  const ex shifted = (derived("78").left - derived("78").right).subs(psi == psi + GiNaC::Pi / 2);
  CHECK(identical(overturning_cosine_pulse().residual().subs(rest), shifted));
}

TEST_CASE("from rest the cosine pulse does what half a sine does, on the other side") {
  const ex half = (GiNaC::Pi - psi) / omega_p;
  const ThresholdEquation half_sine = threshold_without_impact(
      Side::negative, ground_acceleration(Pulse::sine), amplitude(Pulse::sine), half);
  const ex residual = half_sine.residual().subs(lst{theta_0 == 0, thetadot_0 == 0});
  CHECK(
      identical(residual.subs(psi == GiNaC::Pi / 2 - psi), overturning_cosine_pulse_from_rest().residual()));
}

TEST_CASE("(78) has no root at a rising acceleration, and one at a falling one") {
  const ThresholdEquation found = threshold_without_impact(Side::positive, Pulse::sine);
  for (const double omega_ratio : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    CHECK(std::isnan(threshold(found, omega_ratio, 1e-3, std::acos(0))));
    CHECK(threshold(found, omega_ratio, std::acos(0), 3.14) > std::acos(0));
  }
}

TEST_CASE("at the root of (71) the motion stays on its side and creeps into the corner") {
  const ThresholdEquation found = threshold_without_impact(Side::negative, Pulse::sine);
  for (const double omega_ratio : {1.0, 2.0, 4.0}) {
    const double psi = threshold(found, omega_ratio, 1e-3, std::acos(0));
    const Given a = amplitude(Pulse::sine);
    const ex motion = linear_response(Side::negative, Pulse::sine).subs(a.name == a.value);
    const auto at = [&](const ex& e, double t) {
      return value(e, {{"t", t},
                       {"psi", psi},
                       {"omega_p", omega_ratio},
                       {"p", 1},
                       {"alpha", 0.25},
                       {"theta_0", 0},
                       {"thetadot_0", 0},
                       {"g", 9.81}});
    };
    const double end = (2 * std::acos(-1) - psi) / omega_ratio;
    for (int k = 1; k <= 20; ++k) CHECK(at(motion, end * k / 20) < 0);
    CHECK(at(motion.diff(t) + motion + alpha, end) == doctest::Approx(0).epsilon(1e-9));
  }
}

TEST_CASE(
    "a block at rest is pressed down at the start of the cosine pulse and starts in its negative part") {
  CHECK(value(derived("r13").right, {{"alpha", 0.25}, {"p", 2}, {"psi", 1}}) < 0);
  CHECK(identical(derived("r14").left, derived("r14").right));
  const ThresholdEquation found = overturning_cosine_pulse_from_rest();
  for (const double omega_ratio : {1.0, 2.0, 4.0}) {  // more than rocking needs, less than one cannot imagine
    const double psi = threshold(found, omega_ratio, 1e-3, std::acos(0) - 1e-3);
    CHECK(1 / std::cos(psi) > 1);
  }
}
