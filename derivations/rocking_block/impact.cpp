#include <derivations/rocking_block/impact.hpp>

namespace rederive::rocking_block {
using namespace mechanics;
using namespace paper;

using GiNaC::ex;

namespace {

// Returns an element at θ = 0 as seen from O', with (x, y) as in (39): x from O' to the left, y upwards.
Vector seen_from_new_pivot() { return {-x, y}; }

Vector seen_from_old_pivot() { return seen_from_new_pivot() + Vector{2 * b, 0}; }

// Returns the velocity of a point at `arm` from the point about which a body turns clockwise with `rate`.
Vector velocity_of_turning(const Vector& arm, const ex& rate) { return rate * Vector{arm.up, -arm.right}; }

RigidBody block_at_impact() { return rectangle(x, y, 0, 2 * b, 0, 2 * h, rho); }

ex element_momentum_before() {
  const Vector velocity = velocity_of_turning(seen_from_old_pivot(), thetadot_minus);
  return clockwise_cross(seen_from_new_pivot(), velocity).expand();
}

ex in_R_and_alpha(const ex& e) {
  return by_pythagoras(
      e.subs(rho == m / (4 * b * h)).normal().subs(GiNaC::lst{b == R * sin(alpha), h == R * cos(alpha)}));
}

// Returns the expression in sines, which the paper prefers; by_pythagoras leaves cosines.
ex in_sines(const ex& e) {
  const ex any = GiNaC::wild();
  return e.subs(pow(cos(any), 2) == 1 - pow(sin(any), 2)).expand();
}

}  // namespace

ex momentum_before_impact() {
  return in_sines(in_R_and_alpha(over_body(element_momentum_before(), block_at_impact())));
}

ex momentum_after_impact() {
  const Vector arm = seen_from_new_pivot();
  const ex element = clockwise_cross(arm, velocity_of_turning(arm, thetadot_plus));
  return in_R_and_alpha(over_body(element, block_at_impact()));
}

ex momentum_before_impact_by_centre() {
  const Vector from_old{R * sin(alpha), R * cos(alpha)}, from_new{-R * sin(alpha), R * cos(alpha)};
  const Vector velocity = velocity_of_turning(from_old, thetadot_minus);
  const ex about_centre = moment_of_inertia_about_centre().right * thetadot_minus;
  return in_sines((about_centre + m * clockwise_cross(from_new, velocity)).expand());
}

ex restitution() {
  return (momentum_before_impact().coeff(thetadot_minus, 1) / momentum_after_impact().coeff(thetadot_plus, 1))
      .normal()
      .expand();
}

ex restitution_by_parallel_axes() {
  const ex inertia = moment_of_inertia_about_centre().right + m * pow(R, 2);
  return (momentum_before_impact_by_centre().coeff(thetadot_minus, 1) / inertia).normal().expand();
}

namespace {

Derivation energy_loss_by_inertia() {
  const ex before = J_o / 2 * pow(thetadot_minus, 2), after = J_o / 2 * pow(thetadot_plus, 2);
  return derived(
      E_L, before - after,
      {in_words("Before the impact the block turns about O, after it about O', with the same J_o and with "
                "C at the same height: only kinetic energy is lost")});
}

Derivation energy_loss() {
  const ex inertia = moment_of_inertia_about_pivot().right;
  return derived(E_L, energy_loss_by_inertia().right.subs(J_o == inertia).expand(),
                 {from(energy_loss_by_inertia(), "The kinetic energy lost"), {"with", J_o, inertia}},
                 {{J_o, inertia}});
}

Derivation mass_of_the_block() {
  return derived(over_body(1, block_at_impact()), m,
                 {in_words("Integrate the density over the face of the block")});
}

Derivation equation_39_height() {
  const Parameter height = block_at_impact().over[0];
  return derived(y_end, height.to - height.from, {in_words("The block is 2h high")});
}

Derivation equation_41() {
  RigidBody face = block_at_impact();
  face.density = 1;
  return derived(integral_41, over_body((element_momentum_before() / thetadot_minus).expand(), face),
                 {from("40b", "Integrate # over the face of the block, 0 < x < 2b and 0 < y < 2h")});
}

}  // namespace

// This function is long because it is a list with one entry for each row.
void derive_impact(Derivations& rows) {
  rows.add("u12a", energy_loss_by_inertia);
  rows.add("u12b", energy_loss);
  rows.add("35", [] {
    return derived(
        E_L, energy_loss().right.subs(thetadot_plus == e * thetadot_minus).expand(),
        {from(energy_loss(), "The kinetic energy lost"), {"with (34)", thetadot_plus, e * thetadot_minus}});
  });
  rows.add("u13", mass_of_the_block);
  rows.add("37a", [] {
    const Vector radial{sin(phi), cos(phi)}, along = velocity_of_turning(radial, 1);
    return derived(
        ex_cross_ey, by_pythagoras(clockwise_cross(radial, along)),
        {in_words("e_x points from O to the element, inclined by φ; e_y is e_x turned clockwise by a right "
                  "angle; e_z is the axis of a clockwise turn")});
  });
  rows.add("37b", [] {
    const Vector radial{sin(phi), cos(phi)}, along = velocity_of_turning(radial, 1), to_old_pivot{-1, 0};
    return derived(
        Ex_cross_ey, clockwise_cross(to_old_pivot, along),
        {in_words("E_x points from O' to O: then 2b E_x + r e_x is the place of the element seen from O'")});
  });
  rows.add("38", [] {
    const Vector arm{r * sin(phi) - 2 * b, r * cos(phi)};
    const Vector velocity = velocity_of_turning({r * sin(phi), r * cos(phi)}, thetadot_minus);
    return derived(
        hO_minus, by_pythagoras(clockwise_cross(arm, velocity)),
        {in_words(
            "The element is at 2b E_x + r e_x from O' and moves with r θ̇₋ e_y; take the cross product")});
  });
  rows.add("u14", [] {
    return derived(dm, rho * dx * dy, {in_words("The density times the area of the element")});
  });
  rows.add("u15", [] {
    return derived(seen_from_old_pivot().right, r * sin(phi),
                   {in_words("x runs from O' to the left: the element is 2b − x to the right of O")});
  });
  rows.add("39", [] {
    return derived(hO_minus, element_momentum_before(),
                   {from("38", "The angular momentum of an element"),
                    in_words("in the coordinates x and y of the block")},
                   {{r, sqrt(pow(y, 2) + pow(2 * b - x, 2))}});
  });
  rows.add("39b", [] {
    const Parameter width = block_at_impact().over[1];
    return derived(x_end, width.to - width.from, {in_words("The block is 2b wide")});
  });
  rows.add("39c", equation_39_height);
  rows.add("40a", [] {
    const Vector arm = seen_from_old_pivot();
    return derived(pow(r, 2), dot(arm, arm), {in_words("Pythagoras, seen from O")});
  });
  rows.add("40b", [] {
    const ex integrand = (element_momentum_before() / thetadot_minus).expand();
    return derived(pow(r, 2) - 2 * b * (2 * b - x), integrand,
                   {from("40a", "With the distance from O"), in_words("the squares of b cancel")});
  });
  rows.add("41", equation_41);
  rows.add("42a", [] {
    return derived(b, R * sin(alpha), {in_words("Half the diagonal, inclined by α to the height")});
  });
  rows.add("42b", [] {
    const ex squares = pow(h, 2);
    return derived(
        equation_41().right, equation_41().right.subs(pow(h, 3) == h * (pow(R, 2) - pow(b, 2))).expand(),
        {from("42a", "With"), {"and Pythagoras", squares, pow(R, 2) - pow(b, 2)}}, {{b, R * sin(alpha)}});
  });
  rows.add("43a", equation_39_height);
  rows.add("43b", [] {
    return derived(HO_minus, momentum_before_impact(),
                   {from("41", "Multiply the integral"), from(mass_of_the_block(), "by the density"),
                    from("42b", "and write it in R and α, as in")});
  });
  rows.add("45a", [] {
    const Vector arm{-r * sin(phi), r * cos(phi)};
    return derived(hO_plus, by_pythagoras(clockwise_cross(arm, velocity_of_turning(arm, thetadot_plus))),
                   {in_words("After the impact the block turns about O', from where r is now measured")});
  });
  rows.add("45b", [] {
    return derived(HO_plus, momentum_after_impact(),
                   {from("45a", "Integrate over the block"), in_words("which is J_o θ̇₊")});
  });
  rows.add("46a", [] {
    return derived(restitution() * thetadot_minus, thetadot_plus,
                   {from("43b", "The impact acts at O' and has no moment about it: the angular momentum #"),
                    from("45b", "stays the same, #")});
  });
  rows.add("46b", [] {
    return derived(e, restitution(),
                   {from("46a", "By # the ratio of the angular velocities is fixed by the shape alone")});
  });
  // Results of our own: an impact that does not act at O' itself
  rows.add("r16", [] {
    const ex half_width = R * sin(alpha);
    // C sinks with b θ̇₋ about O and rises with b θ̇₊ about O': the impulse upwards. It acts at d to the left
    // of O'.
    const ex impulse = m * half_width * (thetadot_minus + thetadot_plus);
    const ex moment = clockwise_cross({-d, 0}, {0, impulse});
    const ex balance = (momentum_after_impact() - momentum_before_impact() - moment).expand();
    const ex rate = -balance.coeff(thetadot_minus, 1) / balance.coeff(thetadot_plus, 1);
    return derived(
        e, rate.normal(),
        {in_words(
             "C sinks with b θ̇₋ about O and rises with b θ̇₊ about O': so much momentum the impact gives it"),
         {"which, acting at d from O', adds to the angular momentum", HO_plus - HO_minus, moment},
         from("43b", "with"),
         from("45b", "and")});
  });
}

}  // namespace rederive::rocking_block
