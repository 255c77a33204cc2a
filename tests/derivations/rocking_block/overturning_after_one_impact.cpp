#include <doctest/doctest.h>

#include <derivations/rocking_block/overturning_after_one_impact.hpp>
#include <tests/identities.hpp>

using namespace rederive::language;
using namespace rederive::numbers;
using namespace rederive::mechanics;
using namespace rederive::rocking_block;
using namespace rederive::test;
using namespace rederive::rocking_block;
using GiNaC::ex;
using GiNaC::lst;

namespace {

ex with_end(const ex& e) { return e.subs(T_ex == end_of_pulse(Pulse::sine)); }

ex residual(const Derivation& d) { return with_end(d.left - d.right); }

double at(const ex& e, double omega_ratio, double psi, double restitution = 0.9, double t_i = 0) {
  return value(
      with_end(e),
      {{"psi", psi}, {"omega_p", omega_ratio}, {"p", 1}, {"alpha", 0.25}, {"e", restitution}, {"t_i", t_i}});
}

/// The ends of the window of r9 for omega_p/p: {psi of the larger amplitude, psi of the smaller}.
std::pair<double, double> window(double omega_ratio) {
  const ex ends = residual(derived("r9")), without_impact = residual(derived("71"));
  const auto f = [&](double psi) { return at(ends, omega_ratio, psi); };
  const double first_mode = root([&](double psi) { return at(without_impact, omega_ratio, psi); }, 1e-3, 1.5);
  double best = first_mode;
  for (int k = 0; k <= 100; ++k)  // the fastest return in between
    if (const double psi = first_mode + (1.5 - first_mode) * k / 100; f(psi) > f(best)) best = psi;
  return {root(f, first_mode, best), root(f, best, 1.57)};
}

}  // namespace

TEST_CASE("the motion after the impact leaves upright with e times the velocity, and obeys its equation") {
  const lst constants{A_3 == derived("82").right, A_4 == derived("81").right};
  const ex motion = derived("79a").right.subs(constants);
  CHECK(identical(motion.subs(t == t_i), 0));
  CHECK(identical(motion.diff(t).subs(t == t_i), e * thetadot_before));
  const Given a = amplitude(Pulse::sine);
  const ex forcing = linear_equation(Side::positive, Pulse::sine).forcing.subs(a.name == a.value);
  CHECK(identical(motion.diff(t, 2) - pow(p, 2) * motion, forcing));
}

TEST_CASE("(86) is solved by the start, where the block is upright too") {
  CHECK(identical(impact_during_pulse().subs(t_i == 0), 0));
}

TEST_CASE("an impact at the very end of the pulse is both during and after it") {
  const ex end = t_i == end_of_pulse(Pulse::sine);
  const ex scale = (1 + pow(omega_p / p, 2)) * sin(psi);
  CHECK(
      identical(with_end(impact_during_pulse()).subs(end), with_end(impact_after_pulse() * scale).subs(end)));
  // (88) is −(1 + w²) sin ψ/w of e θ̇/(p α) − 1
  const ex factor = -scale * p / omega_p;
  CHECK(identical(with_end(overturning_impact_during_pulse()).subs(end),
                  with_end(overturning_impact_after_pulse() * factor).subs(end)));
}

TEST_CASE("(94a) and (94b) have no common solution at a finite time") {
  // Linear in θ̇_after/p and α: the determinant is sinh² − cosh².
  const ex a = derived("94a").left, b = derived("94b").left;
  const ex determinant = a.coeff(thetadot_after, 1) * b.expand().coeff(alpha, 1) -
                         b.coeff(thetadot_after, 1) * a.expand().coeff(alpha, 1);
  CHECK(identical(determinant * p, 1));
}

TEST_CASE("eliminating the impact time from (92a) and (96) leaves r9") {
  const ex angle = impact_after_pulse() + 1, rate = (overturning_impact_after_pulse() + 1) / e;
  CHECK(identical(pow(rate, 2) - pow(angle, 2), derived("r9").left));
}

TEST_CASE("both ends of the window satisfy (92a) and (96), at the impact time of r11") {
  const ex time = residual(derived("r11"));
  const ex upright = with_end(impact_after_pulse()), critical = with_end(overturning_impact_after_pulse());
  for (const double omega_ratio : {5.0, 5.5, 6.0}) {
    const auto [upper, lower] = window(omega_ratio);
    REQUIRE(upper < lower);
    for (const double psi : {upper, lower}) {
      const double t_i = root([&](double t) { return at(time, omega_ratio, psi, 0.9, t); }, 0, 20);
      CHECK(t_i > (2 * std::acos(-1) - psi) / omega_ratio);
      CHECK(at(upright, omega_ratio, psi, 0.9, t_i) == doctest::Approx(0).epsilon(1e-8));
      CHECK(at(critical, omega_ratio, psi, 0.9, t_i) == doctest::Approx(0).epsilon(1e-8));
    }
  }
}

TEST_CASE("at the threshold without impact a returning block is too slow: the window ends below it") {
  CHECK(identical(derived("r12").right, p * alpha));
  const ex threshold = residual(derived("71")), ends = residual(derived("r9"));
  const ex energy = with_end(derived("r9").left);
  for (const double omega_ratio : {1.0, 3.0, 6.0}) {
    const double psi = root([&](double x) { return at(threshold, omega_ratio, x); }, 1e-3, 1.5);
    CHECK(at(energy, omega_ratio, psi) == doctest::Approx(0).epsilon(1e-8));
    CHECK(at(ends, omega_ratio, psi) < 0);
  }
}

TEST_CASE("a block that loses nothing at the impact has a window that reaches the threshold without impact") {
  CHECK(derived("r9").right.subs(e == 1).is_zero());
}
