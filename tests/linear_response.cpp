#include <doctest/doctest.h>

#include <derivations/rocking_block/initial_conditions.hpp>

#include "identities.hpp"

using namespace rederive;
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
  const Letters& s = letters();
  for (const Side side : sides)
    for (const Pulse pulse : pulses) {
      const ex motion = linear_response(side, pulse);
      const LinearEquation equation = linear_equation(side, pulse);
      CHECK(identical(motion.diff(s.t, 2) - pow(equation.k, 2) * motion, equation.forcing));
      CHECK(identical(motion.subs(s.t == 0), s.theta_0));
      CHECK(identical(motion.diff(s.t).subs(s.t == 0), s.thetadot_0));
    }
}

TEST_CASE("by half phases it is the same motion, and begins without a difference of large terms") {
  const Letters& s = letters();
  for (const Side side : sides) {
    const ex motion = linear_response(side, Pulse::sine), halved = by_half_phases(motion);
    CHECK(identical(motion, halved));
    CHECK(halved.coeff(s.theta_0, 0)
              .subs(lst{sinh(s.p * s.t / 2) == 0, sin(s.omega_p * s.t / 2) == 0})
              .expand()
              .is_zero());
  }
}

TEST_CASE("the linear equation is the tangent of the exact one") {
  const Letters& s = letters();
  const SymbolExpression size = s.rho;  // any symbol that the equation does not have
  for (const Side side : sides) {
    const ex exact = angular_acceleration(side).subs(s.u_gddot == ground_acceleration(Pulse::sine));
    const LinearEquation linear = linear_equation(side, Pulse::sine);
    const ex difference =
        (exact - pow(linear.k, 2) * s.theta - linear.forcing)
            .subs(lst{s.theta == size * s.theta, s.alpha == size * s.alpha, s.a_p == size * s.a_p});
    CHECK(difference.subs(size == 0).is_zero());
    CHECK(difference.diff(size).subs(size == 0).expand().is_zero());
  }
}

TEST_CASE("the amplitude leaves the linear block on the point of moving at t = 0") {
  const Letters& s = letters();
  for (const Pulse pulse : {Pulse::sine, Pulse::cosine}) {
    const Given a = amplitude(pulse);
    CHECK(
        identical(linear_equation(Side::negative, pulse).forcing.subs(s.t == 0).subs(a.name == a.value), 0));
  }
}

TEST_CASE("free linear motion keeps p²(θ ± α)² − θ̇²") {
  const Letters& s = letters();
  for (const Side side : sides) {
    const ex motion = free_motion(side), corner = side == Side::negative ? ex(-s.alpha) : ex(s.alpha);
    const ex kept = pow(s.p * (motion - corner), 2) - pow(motion.diff(s.t), 2);
    CHECK(identical(kept.diff(s.t), 0));
  }
}

TEST_CASE(
    "free linear motion comes upright with the velocity, and is critical at the rate, that it is said to") {
  const Letters& s = letters();
  for (const Side side : sides) {
    const LinearEquation equation = linear_equation(side, Pulse::none);
    const ex motion = solution_from(equation, 0, s.theta_0, s.thetadot_0);
    const auto along = [&](const ex& e) {
      return e.subs(lst{s.theta == motion, s.thetadot == motion.diff(s.t)});
    };
    const ex square = linear_impact_rate_squared(side);
    CHECK(identical(along(square).diff(s.t), 0));
    CHECK(identical(square.subs(s.theta == 0), pow(s.thetadot, 2)));
    CHECK(identical(
        growing_part(motion.subs(s.thetadot_0 == linear_critical_rate(side).subs(s.theta == s.theta_0)), 0),
        0));
  }
}

TEST_CASE("under a line of ground acceleration the linear motion obeys its equation") {
  const Letters& s = letters();
  for (const Side side : sides) {
    const LinearEquation equation = linear_equation_under(side, s.a_p * (s.lambda + s.mu * s.t));
    const ex motion = solution_from(equation, 0, s.theta_0, s.thetadot_0);
    CHECK(identical(motion.diff(s.t, 2) - pow(equation.k, 2) * motion, equation.forcing));
    CHECK(identical(motion.subs(s.t == 0), s.theta_0));
    CHECK(identical(motion.diff(s.t).subs(s.t == 0), s.thetadot_0));
  }
}

TEST_CASE("without its growing part a free motion dies away to the corner") {
  const Letters& s = letters();
  const ex motion = free_motion(Side::positive);
  const ex growing = growing_part(motion, s.t_o);
  const ex critical = motion.subs(s.Abar_3 == s.Abar_3 - 2 * growing);
  CHECK(identical(critical - s.alpha, s.Abar_4 * exp(-s.p * (s.t - s.t_o))));
}

TEST_CASE("the pulse has stopped accelerating the ground where it ends") {
  const Letters& s = letters();
  for (const Pulse pulse : {Pulse::sine, Pulse::cosine})
    CHECK(identical(ground_acceleration(pulse).subs(s.t == end_of_pulse(pulse)), 0));
}

TEST_CASE("(104) without a push is (71), and (103) without one is (78) a quarter of a turn later") {
  const Letters& s = letters();
  const lst rest{s.theta_0 == 0, s.thetadot_0 == 0};
  CHECK(identical(overturning_sine_pulse().residual().subs(rest), equation_71().left - equation_71().right));
  const ex shifted = (equation_78().left - equation_78().right).subs(s.psi == s.psi + GiNaC::Pi / 2);
  CHECK(identical(overturning_cosine_pulse().residual().subs(rest), shifted));
}

TEST_CASE("from rest the cosine pulse does what half a sine does, on the other side") {
  const Letters& s = letters();
  const ex half = (GiNaC::Pi - s.psi) / s.omega_p;
  const ThresholdEquation half_sine = threshold_without_impact(
      Side::negative, ground_acceleration(Pulse::sine), amplitude(Pulse::sine), half);
  const ex residual = half_sine.residual().subs(lst{s.theta_0 == 0, s.thetadot_0 == 0});
  CHECK(identical(residual.subs(s.psi == GiNaC::Pi / 2 - s.psi),
                  overturning_cosine_pulse_from_rest().residual()));
}

TEST_CASE("(78) has no root at a rising acceleration, and one at a falling one") {
  const ThresholdEquation found = threshold_without_impact(Side::positive, Pulse::sine);
  for (const double omega_ratio : {0.5, 1.0, 2.0, 4.0, 8.0}) {
    CHECK(std::isnan(threshold(found, omega_ratio, 1e-3, std::acos(0))));
    CHECK(threshold(found, omega_ratio, std::acos(0), 3.14) > std::acos(0));
  }
}

TEST_CASE("at the root of (71) the motion stays on its side and creeps into the corner") {
  const Letters& s = letters();
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
    CHECK(at(motion.diff(s.t) + motion + s.alpha, end) == doctest::Approx(0).epsilon(1e-9));
  }
}

TEST_CASE(
    "a block at rest is pressed down at the start of the cosine pulse and starts in its negative part") {
  const Letters& s = letters();
  CHECK(value(first_acceleration_to_the_right().right, {{"alpha", 0.25}, {"p", 2}, {"psi", 1}}) < 0);
  CHECK(identical(start_under_cosine().left, start_under_cosine().right));
  const ThresholdEquation found = overturning_cosine_pulse_from_rest();
  for (const double omega_ratio : {1.0, 2.0, 4.0}) {  // more than rocking needs, less than one cannot imagine
    const double psi = threshold(found, omega_ratio, 1e-3, std::acos(0) - 1e-3);
    CHECK(1 / std::cos(psi) > 1);
  }
  (void)s;
}
