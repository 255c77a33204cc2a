// The one-sine and the one-cosine pulse, (52) to (55), (97).
#pragma once

#include <derivations/paper/derivations.hpp>
#include <derivations/paper/steps.hpp>
#include <emitted/rocking_block_symbols.hpp>

namespace rederive::rocking_block {

/// Forms of the ground acceleration: none, α_p sin(ω_p t + ψ) of (52), or α_p cos(ω_p t + ψ) of (97).
enum class Pulse { none, sine, cosine };
/// Returns the ground acceleration, an expression in t.
GiNaC::ex ground_acceleration(Pulse pulse);
/// Returns the time at which the pulse ends: at phase 2π of the sine, 3π/2 of the cosine.
GiNaC::ex end_of_pulse(Pulse pulse);

/// Derive the phase ψ at which a pulse begins with a share λ of its amplitude, and the time at which it ends.
mechanics::Derivation equation_53c();
mechanics::Derivation end_of_sine_pulse();

/// Adds the derivations of (52) to (55).
void derive_pulse(paper::Derivations& rows);

}  // namespace rederive::rocking_block
