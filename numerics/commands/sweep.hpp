// Long computations on the command line: threads, progress on a terminal, Ctrl-C keeps what is done.
#pragma once

#include <numerics/parallel.hpp>
#include <string>

namespace rederive::inline numeric {

/// From --threads ("" = as many as the machine has, one a rank under mpirun), shared among ranks, with
/// progress on a terminal and stopping at Ctrl-C.
Work sweep_work(const std::string& threads, int count, const char* unit);

/// Whether Ctrl-C was pressed; ends the progress line and says what comes of it.
bool was_interrupted(const Work& work, const char* consequence = "what was done is kept");

}  // namespace rederive::inline numeric
