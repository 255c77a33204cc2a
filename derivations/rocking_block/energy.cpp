#include <derivations/rocking_block/energy.hpp>
#include <stdexcept>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace paper;

using GiNaC::ex;

ex energy(Side side) { return kinetic_energy(side) + weight_potential(side); }

ex energy_rate(Side side) {
  const ex along_motion = angular_acceleration(side);
  ex rate = time_derivative(energy(side), block_rates()).subs(thetaddot == along_motion);
  for (const Given& given : inertia_and_frequency()) rate = rate.subs(given.name == given.value);
  return rate.expand();
}

namespace {

Derivation total_energy() {
  return assuming(derived(E, K + Omega,
                          {in_words("The block moves and is lifted; it is rigid, so nothing else "
                                    "stores energy")},
                          {{V_s, 0}}),
                  "V_s = 0: what the paper calls V is a strain energy, and the block is rigid");
}

Derivation energy_of(Side side, const char* kinetic, const char* potential) {
  return derived(E, energy(side),
                 {from(kinetic, "Add the kinetic energy"), from(potential, "and the potential")});
}

// Derives the ground acceleration at θ = α from (21) with θ̈ = 0.
Derivation ground_at_alpha(Side side, const char* motion) {
  const ex rest = angular_acceleration(side).subs(theta == alpha);
  return derived(
      u_gddot_alpha, -rest.coeff(u_gddot, 0) / rest.coeff(u_gddot, 1),
      {from(motion, "Put θ = α and θ̈ = 0 into"), in_words("and solve for the ground acceleration")});
}

// The potential of the weight: Ω/(m g R) is factor·cos(lean) + a constant.
struct Weight {
  ex lean, factor;
};

Weight weight_of(Side side) {
  const ex potential = (weight_potential(side) / (m * g * R)).expand(), any = GiNaC::wild();
  GiNaC::exset cosines;
  potential.find(cos(any), cosines);
  for (const ex& cosine : cosines)
    if (cosine.has(theta)) return {cosine.op(0), potential.coeff(cosine, 1)};
  throw std::logic_error("the potential of the weight has no cosine of theta");
}

// Returns cos a − cos b as the product 2 sin((a + b)/2) sin((b − a)/2).
ex difference_of_cosines(const ex& a, const ex& b) {
  return 2 * sin(((a + b) / 2).expand()) * sin(((b - a) / 2).expand());
}

// Returns what a potential of differences of cosines adds to θ̇²: 2 Ω/J_o, in p² alone.
ex rate_squared(const Weight& weight, const ex& difference) {
  const ex inertia = 2 * energy(Side::negative).coeff(thetadot, 2);
  ex scale = 2 * m * g * R / inertia;
  for (const Given& given : inertia_and_frequency()) scale = scale.subs(given.name == given.value);
  return scale.normal() * weight.factor * difference;
}

// Returns the square root of a product of squares. It is positive where their bases are.
ex root_of_square(const ex& square) {
  ex root = 1;
  for (std::size_t i = 0; i < square.nops(); ++i) {
    const ex factor = square.op(i);
    root *= GiNaC::is_a<GiNaC::power>(factor) ? pow(factor.op(0), factor.op(1) / 2) : sqrt(factor);
  }
  return root;
}

Step energies_of(Side side, const std::string& says) {
  return side == Side::negative ? from("22a", says) : from("22b", says);
}

Step as_product(const ex& a, const ex& b) {
  return {"A difference of cosines is a product", cos(a) - cos(b), difference_of_cosines(a, b)};
}

}  // namespace

Derivation critical_rate(Side side) {
  const Weight weight = weight_of(side);
  const ex corner = weight.lean.subs(theta == (side == Side::negative ? ex(-alpha) : ex(alpha)));
  const ex speed = root_of_square(rate_squared(weight, difference_of_cosines(corner, weight.lean)));
  return derived(thetadot, side == Side::negative ? ex(-speed) : speed,
                 {energies_of(side, "The energy # is that of θ = ∓α without velocity"),
                  as_product(corner, weight.lean), in_words("and it is a square: outwards is its root")});
}

Derivation impact_rate_squared(Side side) {
  const Weight weight = weight_of(side);
  const ex upright = weight.lean.subs(theta == 0);
  const ex gained = rate_squared(weight, difference_of_cosines(weight.lean, upright));
  return derived(
      pow(thetadot_before, 2), pow(thetadot, 2) + gained,
      {energies_of(side, "The energy # is that of θ = 0 with θ̇_before"), as_product(weight.lean, upright)});
}

// This function is long because it is a list with one entry for each row.
void derive_energy(Derivations& rows) {
  rows.add("u6", [] { return ground_at_alpha(Side::negative, "21a"); });
  rows.add("u7", [] { return ground_at_alpha(Side::positive, "21b"); });
  rows.add("u8", total_energy);
  rows.add("22a", [] { return energy_of(Side::negative, "6", "9"); });
  rows.add("22b", [] { return energy_of(Side::positive, "16b", "14"); });
}

}  // namespace rederive::rocking_block
