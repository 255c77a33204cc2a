#include <derivations/rocking_block/initial_conditions.hpp>

namespace rederive::rocking_block {
using namespace language;
using namespace mechanics;
using namespace paper;

using GiNaC::ex;
using GiNaC::lst;

namespace {

ex cosine_motion() { return with_amplitude(forced_motion(Side::positive, Pulse::cosine), Pulse::cosine); }

// Returns the ground acceleration with time counted from phase π − ψ on: α_p cos(π − ψ + ω_p t), which is
// −α_p cos(ψ − ω_p t). It starts at −α g.
ex cosine_after_wait() { return -a_p * cos(psi - omega_p * t); }

Derivation threshold(const ThresholdEquation& found, std::vector<Step> steps, std::vector<Given> given) {
  return derived(found.left, found.right, std::move(steps), std::move(given));
}

Given end(Pulse pulse) { return {T_ex, end_of_pulse(pulse)}; }

}  // namespace

ThresholdEquation overturning_cosine_pulse() {
  return threshold_without_impact(Side::positive, Pulse::cosine);
}

ThresholdEquation overturning_sine_pulse() { return threshold_without_impact(Side::negative, Pulse::sine); }

ThresholdEquation overturning_cosine_pulse_from_rest() {
  const ex last = 2 * GiNaC::Pi - GiNaC::Pi / 2, first = GiNaC::Pi - psi;
  const ThresholdEquation any = threshold_without_impact(
      Side::positive, cosine_after_wait(), amplitude(Pulse::cosine), ((last - first) / omega_p).expand());
  return {by_phase(any.left.subs(lst{theta_0 == 0, thetadot_0 == 0})), any.right};
}

namespace {

Derivation cosine_is_shifted_sine() {
  return derived(u_gddot, ground_acceleration(Pulse::cosine), {in_words("A sine a quarter of a turn ahead")});
}

Derivation first_acceleration_of_cosine() {
  return derived(u_gddot_0, ground_acceleration(Pulse::cosine).subs(t == 0), {in_words("Set t = 0")});
}

Derivation share_of_cosine() {
  return derived(first_acceleration_of_cosine().right, lambda * a_p,
                 {from(first_acceleration_of_cosine(), "λ is the share of the amplitude at t = 0, and")});
}

}  // namespace

Derivation phase_of_cosine() {
  return derived(psi, acos(lambda), {from(share_of_cosine(), "Solve for ψ, between 0 and π/2,")});
}

namespace {

// Returns the amplitude by λ α_p = g tan α with λ = cos ψ.
ex exact_amplitude() {
  const ex rest = motion_by_lagrange(Side::negative).subs(lst{theta == 0, thetaddot == 0});
  const ex suffices = -rest.coeff(u_gddot, 0) / rest.coeff(u_gddot, 1);
  return suffices / (first_acceleration_of_cosine().right / a_p);
}

Derivation amplitude_of_cosine() {
  return derived(
      a_p, exact_amplitude(),
      {from(first_acceleration_of_cosine(), "The acceleration at t = 0"), in_words("is taken as g tan α")});
}

Derivation scaled_amplitude_of_cosine() {
  return derived(a_p / (g * tan(alpha)), exact_amplitude() * cos(alpha) / (g * sin(alpha)),
                 {from(amplitude_of_cosine(), "Divide by g tan α")});
}

Derivation linear_amplitude_of_cosine() {
  return to_order(derived(a_p / (alpha * g), amplitude(Pulse::cosine).value / (alpha * g),
                          {from(scaled_amplitude_of_cosine(), "To first order in α,")}),
                  1, "alpha");
}

Derivation end_of_cosine_pulse() {
  return derived(T_ex, end_of_pulse(Pulse::cosine),
                 {from(cosine_is_shifted_sine(), "Write the cosine as a shifted sine,"),
                  in_words("and let the pulse end with it, where the phase is 2π")});
}

Derivation start_under_cosine() {
  // Motion to θ > 0 starts where the right side of (97) is 0 at θ = 0: cos(phase) = −cos ψ.
  const LinearEquation equation = linear_equation(Side::positive, Pulse::cosine);
  const ex phase = omega_p * t + psi;
  const ex forcing = with_amplitude(equation.forcing, Pulse::cosine);
  const ex needed = -forcing.coeff(cos(phase), 0) / forcing.coeff(cos(phase), 1);
  return derived(
      cos(GiNaC::Pi - psi), needed,
      {from("97", "The block starts to θ > 0 when the right side of"),
       in_words("is no longer negative at θ = 0: when the cosine has come to −cos ψ, at phase π − ψ")});
}

}  // namespace

// This function is long because it is a list with one entry for each row.
void derive_initial_conditions(Derivations& rows) {
  rows.add("u26", cosine_is_shifted_sine);
  rows.add("u27a", first_acceleration_of_cosine);
  rows.add("u27b", share_of_cosine);
  rows.add("u27c", phase_of_cosine);
  rows.add("u27d", amplitude_of_cosine);
  rows.add("u27e", scaled_amplitude_of_cosine);
  rows.add("97", [] {
    const LinearEquation equation = linear_equation(Side::positive, Pulse::cosine);
    return to_order(derived(thetaddot + equation.stiffness * theta,
                            with_amplitude(equation.forcing, Pulse::cosine).expand(),
                            {from("21b", "Take # to first order in α, θ and α_p/g"),
                             {"with", u_gddot, ground_acceleration(Pulse::cosine)},
                             from(linear_amplitude_of_cosine(), "and")}),
                    1, "alpha, theta, a_p/g");
  });
  rows.add("98", [] {
    return derived(
        theta, cosine_motion(),
        {from("97", "Solve"), in_words("by undetermined coefficients, with sinh p t and cosh p t")});
  });
  rows.add("99", [] {
    return derived(thetadot / p, (cosine_motion().diff(t) / p).expand(), {from("98", "Differentiate")});
  });
  rows.add("100a", [] {
    return derived(A_3, forced_constants(Side::positive, Pulse::cosine).C.normal(),
                   {from("99", "Set t = 0 and θ̇ = θ̇_0 in #")});
  });
  rows.add("100b", [] {
    return derived(A_4, forced_constants(Side::positive, Pulse::cosine).D.normal(),
                   {from("98", "Set t = 0 and θ = θ_0 in")});
  });
  rows.add("u28", end_of_cosine_pulse);
  rows.add("101a", [] {
    return derived(theta_ex, angle_at_end(Side::positive, Pulse::cosine),
                   {from("98", "# at T_ex, where the cosine is 0")});
  });
  rows.add("101b", [] {
    return derived(thetadot_ex / p, rate_at_end(Side::positive, Pulse::cosine),
                   {from("99", "# at T_ex, where the sine is −1")});
  });
  rows.add("102", [] {
    const ex growth = exp(p * T_ex);
    const ex sum = critical_sum(Side::positive, angle_at_end(Side::positive, Pulse::cosine),
                                p * rate_at_end(Side::positive, Pulse::cosine));
    const ex joined = in_exponentials(sum).expand().subs(exp(-p * T_ex) == 1 / growth).expand();
    return derived(joined.coeff(growth, 1), -joined.coeff(growth, 0) / growth,
                   {from("75", "Into"), from("101a", "put"), from("101b", "and"),
                    in_words("sinh and cosh join to e^{p T_ex}")});
  });
  rows.add("103", [] {
    return threshold(overturning_cosine_pulse(),
                     {from("102", "Into"), from("100a", "put"), from("100b", "and"),
                      in_words("and divide by the factor of e^{−p T_ex}")},
                     {end(Pulse::cosine)});
  });
  rows.add("104", [] {
    return threshold(overturning_sine_pulse(),
                     {from("68", "Into"), from("69a", "put"), from("69b", "and"), from("58a", "with"),
                      from("58b", "and"), in_words("and divide by the factor of e^{−p T_ex}")},
                     {end(Pulse::sine)});
  });
  rows.add("u29", linear_amplitude_of_cosine);
  // Results of our own: what the cosine pulse does to a block at rest
  rows.add("r13", [] {
    const LinearEquation equation = linear_equation(Side::positive, Pulse::cosine);
    return derived(
        thetaddot_0, with_amplitude(equation.forcing, Pulse::cosine).subs(t == 0).expand(),
        {from("97", "# at rest and upright, just after t = 0,"),
         in_words("which is negative: the block is pressed onto its base and does not turn to θ > 0. To turn "
                  "to θ < 0 it needs more than α g, and the acceleration decreases")});
  });
  rows.add("r14", start_under_cosine);
  rows.add("r15", [] {
    return threshold(
        overturning_cosine_pulse_from_rest(),
        {from(start_under_cosine(), "Rocking begins, from rest, at phase π − ψ, where"),
         in_words("with time counted from there the acceleration is −α_p cos(ω_p t − ψ), until phase 3π/2"),
         from("75", "The critical motion has"),
         in_words("and dividing by the factor of the exponential gives the threshold: the one of half a "
                  "sine, with π/2 − ψ for its phase")},
        {});
  });
}

}  // namespace rederive::rocking_block
