// The program `emit`: the derived results of a paper as source code.
#pragma once

#include <derivations/emit/emit.hpp>
#include <functional>

namespace rederive::emit {

/// Runs the command line of `emit` for the functions that `emission` returns; it is called when they are
/// needed. Returns the exit code.
int run_emit(const std::function<Emission()>& emission, int argc, char** argv);

}  // namespace rederive::emit
