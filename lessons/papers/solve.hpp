// Integrates an equation of motion of a paper: the steppers of functions.toml.
#pragma once

#include <lessons/papers/paper_folder.hpp>

namespace rederive::papers {

/// Runs the command line of `rederive DIR solve`. Returns the exit code.
int run_solve(const std::function<const PaperFolder&()>& folder, int argc, char** argv);

}  // namespace rederive::papers
