// All checks of a paper's folder, and watching it.
#pragma once

#include <lessons/papers/paper_folder.hpp>

namespace rederive::papers {

/// Runs the command line of `rederive DIR test`: the expected verdicts of rows and claims, the mutants, the
/// exercises' selftest, the lessons in all formats, and the emitted code against values of 50 digits. Returns
/// the exit code: 1 if a check fails.
int run_test(const std::function<const PaperFolder&()>& folder, int argc, char** argv);

/// Runs the command line of `rederive DIR watch`: judges the rows that have changed whenever a file of the
/// folder is saved, until it is interrupted. Returns the exit code.
int run_watch(const std::filesystem::path& folder, int argc, char** argv);

}  // namespace rederive::papers
