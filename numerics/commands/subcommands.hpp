// The subcommands of `rocking`; each is defined in the file of its name.
#pragma once

#include <derivations/program/command_line.hpp>
#include <functional>

namespace rederive::numerics::commands {

/// What the chosen subcommand does; returns the exit code.
using Run = std::function<int()>;

// Each function adds its subcommand to `app`. When the command line has been read and chooses the subcommand,
// `run` is set.
void add_threshold(CLI::App& app, Run& run);
void add_response(CLI::App& app, Run& run);
void add_spectrum(CLI::App& app, Run& run);
void add_map(CLI::App& app, Run& run);
void add_fragility(CLI::App& app, Run& run);
void add_figure(CLI::App& app, Run& run);

}  // namespace rederive::numerics::commands
