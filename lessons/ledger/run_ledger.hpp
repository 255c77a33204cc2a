// The program `ledger`, also for a paper of one's own.
#pragma once

#include <derivations/rocking_block/steps.hpp>
#include <filesystem>
#include <optional>
#include <string>

namespace rederive {

/// What another paper prints, and what derives it: each id of a row with its derivation.
struct OwnPaper {
  std::string title;
  std::filesystem::path equations;  ///< as equations.toml; --equations still takes another file
  Derivations derivations;
};

/// All that `ledger --help` says, about the rocking block or about another paper. Returns the exit code.
int run_ledger(int argc, char** argv, const std::optional<OwnPaper>& own = std::nullopt);

}  // namespace rederive
