// What is emitted of the paper: numeric functions and Taylor steppers.
#pragma once

#include <derivations/emit/emit.hpp>

namespace rederive::rocking_block {

/// Every function and stepper that is emitted, built from the derivations.
Emission emission();
/// Its parts.
std::vector<EmittedFunction> emitted_functions();
std::vector<TaylorStepper> taylor_steppers();
/// The symbols of the paper, and those that only numeric functions have (arguments.hpp).
Symbols emission_symbols();

}  // namespace rederive::rocking_block
