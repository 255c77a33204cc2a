#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/pulse.hpp>

namespace rederive::rocking_block {

using GiNaC::ex;

ex ground_acceleration(Pulse pulse) {
  const ex phase = omega_p * t + psi;
  if (pulse == Pulse::none) return 0;
  return pulse == Pulse::sine ? a_p * sin(phase) : a_p * cos(phase);
}

ex end_of_pulse(Pulse pulse) {
  // The cosine is the sine a quarter of a turn ahead, and ends with it.
  const ex last = pulse == Pulse::cosine ? 2 * GiNaC::Pi - GiNaC::Pi / 2 : 2 * GiNaC::Pi;
  return (last - psi) / omega_p;
}

namespace {

Derivation pulse_begins() {
  return derived(0, omega_p * t + psi, {in_words("One sine: the phase of (52) runs from 0")}, {}, "<=");
}

Derivation pulse_ends() {
  return derived(omega_p * t + psi, 2 * GiNaC::Pi, {in_words("One sine: the phase of (52) runs to 2π")}, {},
                 "<=");
}

Derivation equation_53a() {
  return derived(u_gddot_0, ground_acceleration(Pulse::sine).subs(t == 0), {in_words("Set t = 0 in (52)")});
}

Derivation equation_53b() {
  return derived(ground_acceleration(Pulse::sine).subs(t == 0), lambda * a_p,
                 {from("53a", "λ is the share of the amplitude at t = 0, and by #")});
}

}  // namespace

Derivation equation_53c() {
  return derived(psi, asin(lambda), {from("53b", "Solve # for ψ, between 0 and π/2")});
}

namespace {

Derivation equation_54() {
  const ex share = g * tan(alpha) / a_p;
  return derived(psi, asin(share), {from("53c", "Into"), {"put", lambda, share}});
}

Derivation equation_55a() {
  return derived(slope_of_diagonal(), b / h, {from("32b", "The shape of the block")});
}

Derivation equation_55b() {
  return derived(b / h, mu, {in_words("Inequality (32), without its limit")}, {}, "<");
}

}  // namespace

Derivation end_of_sine_pulse() {
  return derived(T_ex, end_of_pulse(Pulse::sine),
                 {in_words("The phase ω_p t + ψ of (52) has then come to 2π")});
}

Derivations derivations_of_pulse() {
  return {
      {"52b", pulse_begins}, {"52c", pulse_ends},   {"53a", equation_53a},
      {"53b", equation_53b}, {"53c", equation_53c}, {"54", equation_54},
      {"55a", equation_55a}, {"55b", equation_55b}, {"u20", end_of_sine_pulse},
  };
}

}  // namespace rederive::rocking_block
