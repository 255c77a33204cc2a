// What every lesson on the rocking block uses: the paper and its symbols, pictures, experiments, and the
// main.
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <derivations/rocking_block/paper.hpp>
#include <emitted/rocking_block_symbols.hpp>
#include <lessons/illustrations/drawings.hpp>
#include <lessons/illustrations/experiments.hpp>
#include <lessons/page/run_lesson.hpp>

namespace rederive::rocking_block {

/// Prints what the command line asks for of a lesson on the built-in paper. Returns the exit code.
inline int run_lesson(const page::Lesson& lesson, int argc, char** argv) {
  return page::run_lesson(
      paper(), lesson, [] { return page::built_in_series(paper()); }, argc, argv);
}

}  // namespace rederive::rocking_block
