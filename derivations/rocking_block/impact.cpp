#include <derivations/rocking_block/impact.hpp>

namespace rederive {

using GiNaC::ex;

namespace {

// At θ = 0, with (x, y) as in (39): x from O' to the left, y upwards. The element as seen from either corner.
Vector seen_from_new_pivot() { return {-letters().x, letters().y}; }
Vector seen_from_old_pivot() { return seen_from_new_pivot() + Vector{2 * letters().b, 0}; }

// A point at `arm` from the point about which a body turns clockwise with `rate`.
Vector velocity_of_turning(const Vector& arm, const ex& rate) { return rate * Vector{arm.up, -arm.right}; }

Rectangle block_at_impact() {
  const Letters& s = letters();
  return {s.x, s.y, 0, 2 * s.b, 0, 2 * s.h, s.rho};
}

ex element_momentum_before() {
  const Vector velocity = velocity_of_turning(seen_from_old_pivot(), letters().thetadot_minus);
  return clockwise_cross(seen_from_new_pivot(), velocity).expand();
}

ex in_R_and_alpha(const ex& e) {
  const Letters& s = letters();
  return by_pythagoras(e.subs(s.rho == s.m / (4 * s.b * s.h))
                           .normal()
                           .subs(GiNaC::lst{s.b == s.R * sin(s.alpha), s.h == s.R * cos(s.alpha)}));
}

// by_pythagoras leaves cosines; the paper keeps sines.
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
  const ex element = clockwise_cross(arm, velocity_of_turning(arm, letters().thetadot_plus));
  return in_R_and_alpha(over_body(element, block_at_impact()));
}

ex momentum_before_impact_by_centre() {
  const Letters& s = letters();
  const Vector from_old{s.R * sin(s.alpha), s.R * cos(s.alpha)},
      from_new{-s.R * sin(s.alpha), s.R * cos(s.alpha)};
  const Vector velocity = velocity_of_turning(from_old, s.thetadot_minus);
  const ex about_centre = moment_of_inertia_about_centre().right * s.thetadot_minus;
  return in_sines((about_centre + s.m * clockwise_cross(from_new, velocity)).expand());
}

ex restitution() {
  const Letters& s = letters();
  return (momentum_before_impact().coeff(s.thetadot_minus, 1) /
          momentum_after_impact().coeff(s.thetadot_plus, 1))
      .normal()
      .expand();
}

ex restitution_by_parallel_axes() {
  const Letters& s = letters();
  const ex J_o = moment_of_inertia_about_centre().right + s.m * pow(s.R, 2);
  return (momentum_before_impact_by_centre().coeff(s.thetadot_minus, 1) / J_o).normal().expand();
}

Derivation energy_loss_by_inertia() {
  const Letters& s = letters();
  const ex before = s.J_o / 2 * pow(s.thetadot_minus, 2), after = s.J_o / 2 * pow(s.thetadot_plus, 2);
  return derived(
      s.E_L, before - after,
      {in_words("Before the impact the block turns about O, after it about O', with the same J_o and with "
                "C at the same height: only kinetic energy is lost")});
}

Derivation energy_loss() {
  const Letters& s = letters();
  const ex J_o = moment_of_inertia_about_pivot().right;
  return derived(s.E_L, energy_loss_by_inertia().right.subs(s.J_o == J_o).expand(),
                 {from(energy_loss_by_inertia(), "The kinetic energy lost"), {"with", s.J_o, J_o}},
                 {{s.J_o, J_o}});
}

Derivation equation_35() {
  const Letters& s = letters();
  return derived(s.E_L, energy_loss().right.subs(s.thetadot_plus == s.e * s.thetadot_minus).expand(),
                 {from(energy_loss(), "The kinetic energy lost"),
                  {"with (34)", s.thetadot_plus, s.e * s.thetadot_minus}});
}

Derivation mass_of_the_block() {
  const Letters& s = letters();
  return derived(over_body(1, block_at_impact()), s.m,
                 {in_words("Integrate the density over the face of the block")});
}

Derivation equation_37a() {
  const Letters& s = letters();
  const Vector radial{sin(s.phi), cos(s.phi)}, along = velocity_of_turning(radial, 1);
  return derived(
      s.ex_cross_ey, by_pythagoras(clockwise_cross(radial, along)),
      {in_words("e_x points from O to the element, inclined by φ; e_y is e_x turned clockwise by a right "
                "angle; e_z is the axis of a clockwise turn")});
}

Derivation equation_37b() {
  const Letters& s = letters();
  const Vector radial{sin(s.phi), cos(s.phi)}, along = velocity_of_turning(radial, 1), to_old_pivot{-1, 0};
  return derived(
      s.Ex_cross_ey, clockwise_cross(to_old_pivot, along),
      {in_words("E_x points from O' to O: then 2b E_x + r e_x is the place of the element seen from O'")});
}

Derivation equation_38() {
  const Letters& s = letters();
  const Vector arm{s.r * sin(s.phi) - 2 * s.b, s.r * cos(s.phi)};
  const Vector velocity = velocity_of_turning({s.r * sin(s.phi), s.r * cos(s.phi)}, s.thetadot_minus);
  return derived(
      s.hO_minus, by_pythagoras(clockwise_cross(arm, velocity)),
      {in_words("The element is at 2b E_x + r e_x from O' and moves with r θ̇₋ e_y; take the cross product")});
}

Derivation mass_element() {
  const Letters& s = letters();
  return derived(s.dm, s.rho * s.dx * s.dy, {in_words("The density times the area of the element")});
}

Derivation distance_from_pivot() {
  const Letters& s = letters();
  return derived(seen_from_old_pivot().right, s.r * sin(s.phi),
                 {in_words("x runs from O' to the left: the element is 2b − x to the right of O")});
}

Derivation equation_39() {
  const Letters& s = letters();
  return derived(s.hO_minus, element_momentum_before(),
                 {from(Cited{"38", equation_38}, "The angular momentum of an element"),
                  in_words("in the coordinates x and y of the block")},
                 {{s.r, sqrt(pow(s.y, 2) + pow(2 * s.b - s.x, 2))}});
}

Derivation equation_39_width() {
  const Letters& s = letters();
  return derived(s.x_end, block_at_impact().right - block_at_impact().left,
                 {in_words("The block is 2b wide")});
}

Derivation equation_39_height() {
  const Letters& s = letters();
  return derived(s.y_end, block_at_impact().top - block_at_impact().bottom,
                 {in_words("The block is 2h high")});
}

Derivation equation_40a() {
  const Letters& s = letters();
  const Vector arm = seen_from_old_pivot();
  return derived(pow(s.r, 2), dot(arm, arm), {in_words("Pythagoras, seen from O")});
}

Derivation equation_40b() {
  const Letters& s = letters();
  const ex integrand = (element_momentum_before() / s.thetadot_minus).expand();
  return derived(
      pow(s.r, 2) - 2 * s.b * (2 * s.b - s.x), integrand,
      {from(Cited{"40a", equation_40a}, "With the distance from O"), in_words("the squares of b cancel")});
}

Derivation equation_41() {
  const Letters& s = letters();
  Rectangle face = block_at_impact();
  face.density = 1;
  return derived(s.integral_41, over_body((element_momentum_before() / s.thetadot_minus).expand(), face),
                 {from(Cited{"40b", equation_40b},
                       "Integrate # over the face of the block, 0 < x < 2b and 0 < y < 2h")});
}

Derivation equation_42a() {
  const Letters& s = letters();
  return derived(s.b, s.R * sin(s.alpha), {in_words("Half the diagonal, inclined by α to the height")});
}

Derivation equation_42b() {
  const Letters& s = letters();
  const ex squares = pow(s.h, 2);
  return derived(
      equation_41().right,
      equation_41().right.subs(pow(s.h, 3) == s.h * (pow(s.R, 2) - pow(s.b, 2))).expand(),
      {from(Cited{"42a", equation_42a}, "With"), {"and Pythagoras", squares, pow(s.R, 2) - pow(s.b, 2)}},
      {{s.b, s.R * sin(s.alpha)}});
}

Derivation equation_43a() { return equation_39_height(); }

Derivation equation_43b() {
  const Letters& s = letters();
  return derived(
      s.HO_minus, momentum_before_impact(),
      {from(Cited{"41", equation_41}, "The integral"), from(mass_of_the_block(), "times the density"),
       from(Cited{"42b", equation_42b}, "in R and α #")});
}

Derivation equation_45a() {
  const Letters& s = letters();
  const Vector arm{-s.r * sin(s.phi), s.r * cos(s.phi)};
  return derived(s.hO_plus, by_pythagoras(clockwise_cross(arm, velocity_of_turning(arm, s.thetadot_plus))),
                 {in_words("After the impact the block turns about O', from where r is now measured")});
}

Derivation equation_45b() {
  const Letters& s = letters();
  return derived(s.HO_plus, momentum_after_impact(),
                 {from(Cited{"45a", equation_45a}, "Integrate over the block"), in_words("which is J_o θ̇₊")});
}

Derivation equation_46a() {
  const Letters& s = letters();
  return derived(restitution() * s.thetadot_minus, s.thetadot_plus,
                 {from(Cited{"43b", equation_43b},
                       "The impact acts at O' and has no moment about it: the angular momentum #"),
                  from(Cited{"45b", equation_45b}, "stays the same, #")});
}

Derivation equation_46b() {
  return derived(letters().e, restitution(),
                 {from(Cited{"46a", equation_46a},
                       "By # the ratio of the angular velocities is fixed by the shape alone")});
}

Derivation restitution_of_spread_impact() {
  const Letters& s = letters();
  const ex half_width = s.R * sin(s.alpha);
  // C sinks with b θ̇₋ about O and rises with b θ̇₊ about O': the impulse upwards. It acts at d to the left of
  // O'.
  const ex impulse = s.m * half_width * (s.thetadot_minus + s.thetadot_plus);
  const ex moment = clockwise_cross({-s.d, 0}, {0, impulse});
  const ex balance = (momentum_after_impact() - momentum_before_impact() - moment).expand();
  const ex rate = -balance.coeff(s.thetadot_minus, 1) / balance.coeff(s.thetadot_plus, 1);
  return derived(
      s.e, rate.normal(),
      {in_words(
           "C sinks with b θ̇₋ about O and rises with b θ̇₊ about O': so much momentum the impact gives it"),
       {"which, acting at d from O', adds to the angular momentum", s.HO_plus - s.HO_minus, moment},
       from(Cited{"43b", equation_43b}, "with"),
       from(Cited{"45b", equation_45b}, "and")});
}

}  // namespace rederive
