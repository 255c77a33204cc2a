// A rod of mass m and length L that swings on a hinge at its end.
#include <rederive/derivations/mechanics/linear_motion.hpp>
#include <rederive/derivations/mechanics/plane.hpp>
#include <rederive/derivations/paper/run_derive.hpp>

using namespace rederive::mechanics;
using namespace rederive::paper;
using GiNaC::ex;

namespace {

void derive(const rederive::language::Symbols& symbols, Derivations& rows) {
  const auto &m = symbols["m"], &L = symbols["L"], &J = symbols["J"], &x = symbols["x"], &g = symbols["g"],
             &theta = symbols["theta"], &thetadot = symbols["thetadot"], &thetaddot = symbols["thetaddot"],
             &omega_0 = symbols["omega_0"];
  const ex inertia = integral(pow(x, 2) * m / L, x, 0, L);
  rows.add("1", [=] {
    return derived(J, inertia, {in_words("Integrate $x^2$ over the mass of all elements, $m/L$ per length")});
  });

  const ex kinetic = inertia / 2 * pow(thetadot, 2), potential = m * g * L / 2 * (1 - cos(theta));
  const Rates rates{{theta, thetadot}, {thetadot, thetaddot}};
  const ex motion = lagrange_terms(kinetic, potential, {theta, thetadot, thetaddot}, rates).sum().expand();
  const ex acceleration = -motion.coeff(thetaddot, 0) / motion.coeff(thetaddot, 1);
  rows.add("2", [=] {
    return derived(thetaddot, acceleration,
                   {in_words("Lagrange's equation, with the weight in the middle of the rod")});
  });

  rows.add("3", [=] {
    const ex linear = taylor(acceleration, {theta}, 1);
    return derived(omega_0, sqrt(-linear.coeff(theta, 1)), {{"For small angles", thetaddot, linear}});
  });
}

}  // namespace

int main(int argc, char** argv) { return run_derive(derive, argc, argv); }
