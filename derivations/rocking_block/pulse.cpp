#include <derivations/rocking_block/initiation.hpp>
#include <derivations/rocking_block/pulse.hpp>

namespace rederive::rocking_block {
using namespace mechanics;
using namespace paper;

using GiNaC::ex;

ex ground_acceleration(Pulse pulse) {
  const ex phase = omega_p * t + psi;
  if (pulse == Pulse::none) return 0;
  return pulse == Pulse::sine ? a_p * sin(phase) : a_p * cos(phase);
}

ex end_of_pulse(Pulse pulse) {
  // The cosine is the sine with a phase larger by π/2, and ends with it.
  const ex last = pulse == Pulse::cosine ? 2 * GiNaC::Pi - GiNaC::Pi / 2 : 2 * GiNaC::Pi;
  return (last - psi) / omega_p;
}

Derivation equation_53c() {
  return derived(psi, asin(lambda), {from("53b", "Solve # for ψ, between 0 and π/2")});
}

Derivation end_of_sine_pulse() {
  return derived(T_ex, end_of_pulse(Pulse::sine),
                 {in_words("The phase ω_p t + ψ of (52) has then come to 2π")});
}

// This function is long because it is a list with one entry for each row.
void derive_pulse(Derivations& rows) {
  rows.add("52b", [] {
    return derived(0, omega_p * t + psi, {in_words("One sine: the phase of (52) runs from 0")}, {}, "<=");
  });
  rows.add("52c", [] {
    return derived(omega_p * t + psi, 2 * GiNaC::Pi, {in_words("One sine: the phase of (52) runs to 2π")}, {},
                   "<=");
  });
  rows.add("53a", [] {
    return derived(u_gddot_0, ground_acceleration(Pulse::sine).subs(t == 0), {in_words("Set t = 0 in (52)")});
  });
  rows.add("53b", [] {
    return derived(ground_acceleration(Pulse::sine).subs(t == 0), lambda * a_p,
                   {from("53a", "λ is the share of the amplitude at t = 0, and by #")});
  });
  rows.add("53c", equation_53c);
  rows.add("54", [] {
    const ex share = g * tan(alpha) / a_p;
    return derived(psi, asin(share), {from("53c", "Into"), {"put", lambda, share}});
  });
  rows.add("55a",
           [] { return derived(slope_of_diagonal(), b / h, {from("32b", "The shape of the block")}); });
  rows.add("55b",
           [] { return derived(b / h, mu, {in_words("Inequality (32), without its limit")}, {}, "<"); });
  rows.add("u20", end_of_sine_pulse);
}

}  // namespace rederive::rocking_block
