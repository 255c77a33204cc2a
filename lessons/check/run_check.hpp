// The command line of `rederive check`.
#pragma once

namespace rederive::check {

/// Judges the formulas of manuscripts in LaTeX, Markdown or notebooks. Returns 0, 1 if a step is wrong (or,
/// with
/// --strict, holds under conditions only), or 2 for a file that cannot be read.
int run_check(int argc, char** argv);

}  // namespace rederive::check
