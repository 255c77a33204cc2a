// Time derivatives along a motion, and Lagrange's equation.
#include <doctest/doctest.h>

#include <derivations/mechanics/time_derivative.hpp>
#include <tests/derivations/mechanics/letters.hpp>

using namespace rederive::language;
using namespace rederive::mechanics;
using namespace rederive::test;
using GiNaC::ex;

namespace {

SymbolExpression real(const std::string& name) { return letter(name, "(-inf, inf)"); }

const SymbolExpression m = letter("m"), M = letter("M"), g = letter("g"), L = letter("L"), k = letter("k"),
                       c = letter("c"), F = real("F");
const Coordinate angle{real("theta"), real("thetadot"), real("thetaddot")};
const Coordinate cart{real("x"), real("xdot"), real("xddot")};
const ex theta = angle.position, thetadot = angle.rate;

Rates rates() {
  return {{angle.position, angle.rate},
          {angle.rate, angle.second_rate},
          {cart.position, cart.rate},
          {cart.rate, cart.second_rate}};
}

}  // namespace

TEST_CASE("a time derivative obeys the chain and product rules, and constants have none") {
  CHECK(same(time_derivative(L * sin(theta), rates()), L * cos(theta) * thetadot));
  CHECK(same(time_derivative(theta * thetadot, rates()), pow(thetadot, 2) + theta * angle.second_rate));
  CHECK(time_derivative(pow(L, 3), rates()).is_zero());
}

TEST_CASE("Lagrange gives the equation of the pendulum") {
  const ex kinetic = m * pow(L * thetadot, 2) / 2, potential = -m * g * L * cos(theta);
  const LagrangeTerms terms = lagrange_terms(kinetic, potential, angle, rates());
  CHECK(same(terms.sum(), m * pow(L, 2) * angle.second_rate + m * g * L * sin(theta)));
  CHECK(
      formulas(terms.steps) ==
      "dK_dthetadot = m*L^2*thetadot; ddt_dK_dthetadot = m*L^2*thetaddot; dOmega_dtheta = m*g*L*sin(theta); "
      "m*L^2*thetaddot + m*g*L*sin(theta) = 0");
  CHECK_THROWS_AS(lagrange_terms(kinetic, potential * thetadot, angle, rates()), std::invalid_argument);
}

TEST_CASE("Rayleigh's dissipation and a force: a driven oscillator") {
  const LagrangeTerms terms = lagrange_terms(m * pow(cart.rate, 2) / 2, k * pow(cart.position, 2) / 2, cart,
                                             rates(), c * pow(cart.rate, 2) / 2, F);
  CHECK(same(terms.sum(), m * cart.second_rate + c * cart.rate + k * cart.position - F));
  CHECK(formulas(terms.steps).find("dD_dxdot = c*xdot; Q_x = F") != std::string::npos);
}

TEST_CASE("a pendulum on a cart with a damper: the energy decreases by twice the dissipation") {
  const ex xdot = cart.rate;
  const ex kinetic =
      M * xdot * xdot / 2 +
      m * (xdot * xdot + 2 * L * xdot * thetadot * cos(theta) + L * L * thetadot * thetadot) / 2;
  const ex potential = -m * g * L * cos(theta),
           dissipation = c * xdot * xdot / 2 + k * thetadot * thetadot / 2;
  const auto equation = [&](const Coordinate& q) {
    return lagrange_terms(kinetic, potential, q, rates(), dissipation).sum();
  };
  // For a kinetic energy of second degree in the rates, Σ q̇ (d/dt ∂K/∂q̇ − ∂K/∂q + ∂V/∂q) = d/dt (K + V).
  const ex power = xdot * equation(cart) + thetadot * equation(angle);
  CHECK(same(power - time_derivative(kinetic + potential, rates()), 2 * dissipation));
}
