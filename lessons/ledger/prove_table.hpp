// A table of statements with the expected verdict of each: what the prover can decide, and what it cannot.
#pragma once

#include <derivations/paper/prove_bounded.hpp>
#include <filesystem>

namespace rederive::ledger {

struct TableRow {
  std::string group;     ///< the heading above the row
  std::string why;       ///< the reason for the row
  std::string expected;  ///< a verdict, or "refused" for an input that cannot be used
  bool limit = false;    ///< a known limit: the statement is true, and the verdict is undecided
  paper::ProveRequest request;
};

/// Reads a table such as tests/prove_table.toml. Throws BadInput, with the place, for a file that cannot be
/// used.
std::vector<TableRow> read_table(const std::filesystem::path& file);

struct DecidedRow {
  TableRow row;
  std::string verdict;  ///< as computed
  std::string reason;   ///< for it; what is wrong with an input that is refused
};

/// Decides every row within the bounds of decide_bounded(). Shows the progress on a terminal.
std::vector<DecidedRow> decide_table(const paper::Paper& paper, const std::vector<TableRow>& rows);

/// Returns {"rows": [{"group", "left", "right", "assume", "small", "order", "verdict", "expected", "limit",
/// "reason"}], "counts": {verdict: rows}}
nlohmann::ordered_json to_json(const std::vector<DecidedRow>& rows);

/// Returns the table as a Markdown page with a section for each group. Unexpected verdicts are marked.
std::string table_page(const std::vector<DecidedRow>& rows);

}  // namespace rederive::ledger
