// Begins a paper: copies one of the examples that ship.
#pragma once

namespace rederive::papers {

/// Runs the command line of `rederive new DIR`. Returns the exit code.
int run_new(int argc, char** argv);

}  // namespace rederive::papers
