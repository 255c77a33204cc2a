// The one-sine and the one-cosine pulse, (52) to (55), (97).
#pragma once

#include <derivations/paper/derivations.hpp>
#include <derivations/paper/steps.hpp>
#include <derivations/rocking_block/symbols.hpp>

namespace rederive::rocking_block {

/// The ground acceleration: none, α_p sin(ω_p t + ψ) of (52), or α_p cos(ω_p t + ψ) of (97).
enum class Pulse { none, sine, cosine };
GiNaC::ex ground_acceleration(Pulse pulse);
/// When it ends: where the sine has come to 2π, the cosine to 3π/2.
GiNaC::ex end_of_pulse(Pulse pulse);

Derivation equation_53c();
Derivation end_of_sine_pulse();

/// (52) to (55).
Derivations derivations_of_pulse();

}  // namespace rederive::rocking_block
