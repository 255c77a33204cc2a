// The program `ledger`, also for a paper of one's own.
#pragma once

#include <derivations/rocking_block/steps.hpp>
#include <filesystem>
#include <optional>
#include <source_location>
#include <string>

namespace rederive {

/// What another paper prints, and what derives it: each id of a row with its derivation.
struct OwnPaper {
  std::string title;
  std::filesystem::path equations;  ///< as equations.toml; --equations still takes another file
  Derivations derivations;
  /// The file that says this: a relative name of the equations is looked for beside it.
  std::source_location source = std::source_location::current();
};

/// All that `ledger --help` says, about the rocking block or about another paper. A derivation that throws,
/// or holds what cannot be judged, makes an error of its row alone. Returns the exit code: 2, and says why,
/// where an id is derived twice or has no row, and for symbols that are declared wrongly.
int run_ledger(int argc, char** argv, const std::optional<OwnPaper>& own = std::nullopt);

}  // namespace rederive
