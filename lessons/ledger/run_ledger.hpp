// The program `ledger`, for any paper.
#pragma once

#include <derivations/paper/paper.hpp>
#include <derivations/paper/steps.hpp>
#include <functional>
#include <lessons/ledger/claims.hpp>

namespace rederive::ledger {

/// Runs the program for the paper that `paper` returns, and for its claims if it has some. Both functions are
/// called when they are needed. A derivation that throws, or that contains something that cannot be judged,
/// makes only its row an error. Returns the exit code; it is 2, and standard error says why, if a symbol is
/// declared wrongly, an id is derived twice, or a derivation has no row.
int run_ledger(const std::function<paper::Paper()>& paper, int argc, char** argv,
               const std::function<Claims()>& claims = {});
/// Runs the program for a paper without claims.
int run_ledger(const paper::Paper& paper, int argc, char** argv);

}  // namespace rederive::ledger
