#include <derivations/rocking_block/energy.hpp>

namespace rederive {

using GiNaC::ex;

ex energy(Side side) { return kinetic_energy(side) + weight_potential(side); }

ex energy_rate(Side side) {
  const Letters& s = letters();
  const ex along_motion = angular_acceleration(side);
  ex rate = time_derivative(energy(side), block_rates()).subs(s.thetaddot == along_motion);
  for (const Given& given : inertia_and_frequency()) rate = rate.subs(given.name == given.value);
  return rate.expand();
}

namespace {

Derivation energy_of(Side side, const Cited& kinetic, const Cited& potential) {
  return derived(letters().E, energy(side),
                 {from(kinetic, "The kinetic energy"), from(potential, "the potential")});
}

// In (21) with θ̈ = 0, solved for the ground acceleration at θ = α.
Derivation ground_at_alpha(Side side, const Cited& motion) {
  const Letters& s = letters();
  const ex rest = angular_acceleration(side).subs(s.theta == s.alpha);
  return derived(
      s.u_gddot_alpha, -rest.coeff(s.u_gddot, 0) / rest.coeff(s.u_gddot, 1),
      {from(motion, "Put θ = α and θ̈ = 0 into"), in_words("and solve for the ground acceleration")});
}

}  // namespace

Derivation total_energy() {
  const Letters& s = letters();
  Derivation result = derived(s.E, s.K + s.Omega,
                              {in_words("The block moves and is lifted; it is rigid, so nothing else "
                                        "stores energy")},
                              {{s.V_s, 0}});
  result.assumption = "V_s = 0: what the paper calls V is a strain energy, and the block is rigid";
  return result;
}

Derivation equation_22a() {
  return energy_of(Side::negative, Cited{"6", equation_6}, Cited{"9", equation_9});
}
Derivation equation_22b() {
  return energy_of(Side::positive, Cited{"16b", equation_16b}, Cited{"14", equation_14});
}
Derivation ground_at_alpha_by_21a() { return ground_at_alpha(Side::negative, Cited{"21a", equation_21a}); }
Derivation ground_at_alpha_by_21b() { return ground_at_alpha(Side::positive, Cited{"21b", equation_21b}); }

}  // namespace rederive
