// The numeric functions and Taylor steppers that are emitted for the paper.
#pragma once

#include <derivations/emit/emit.hpp>

namespace rederive::rocking_block {

/// Returns every function and stepper that is emitted, built from the derivations.
emit::Emission emission();
/// Return the parts of the emission.
std::vector<emit::EmittedFunction> emitted_functions();
std::vector<emit::TaylorStepper> taylor_steppers();
/// Returns the symbols of the paper and those that only numeric functions have (arguments.hpp).
language::Symbols emission_symbols();

}  // namespace rederive::rocking_block
