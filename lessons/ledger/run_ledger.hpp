// The program `ledger`, for any paper.
#pragma once

#include <derivations/paper/paper.hpp>
#include <derivations/paper/steps.hpp>
#include <functional>
#include <lessons/ledger/claims.hpp>

namespace rederive {

/// All that `ledger --help` says, about the paper that `paper` returns, and its claims if it has some. Both
/// are called when they are needed. A derivation that throws, or holds what cannot be judged, makes an error
/// of its row alone. Returns the exit code: 2, and says why on standard error, where symbols are declared
/// wrongly, an id is derived twice, or a derivation has no row.
int run_ledger(const std::function<Paper()>& paper, int argc, char** argv,
               const std::function<Claims()>& claims = {});
/// The same for a paper that is there already.
int run_ledger(const Paper& paper, int argc, char** argv);

}  // namespace rederive
