// A table of statements with the verdict that is expected of each: what the engine can do, and what it
// cannot.
#pragma once

#include <derivations/paper/prove_bounded.hpp>
#include <filesystem>

namespace rederive {

struct TableRow {
  std::string group, why;  ///< the heading it stands under, and why it is there
  std::string expected;    ///< a verdict, or "refused" for an input that cannot be used
  bool limit = false;      ///< a known limit: the statement is true, and the engine says undecided
  ProveRequest request;
};

/// Reads a table such as tests/prove_table.toml. Throws BadInput naming what is wrong and where.
std::vector<TableRow> read_table(const std::filesystem::path& file);

struct DecidedRow {
  TableRow row;
  std::string verdict, reason;  ///< computed now; of what is "refused" the reason is what is wrong with it
};

/// Decides every row, each within the bounds of decide_bounded(). Shows progress on a terminal.
std::vector<DecidedRow> decide_table(const Paper& paper, const std::vector<TableRow>& rows);

/// {"rows": [{"group", "left", "right", "assume", "small", "order", "verdict", "expected", "limit",
/// "reason"}], "counts": {verdict: rows}}
nlohmann::ordered_json to_json(const std::vector<DecidedRow>& rows);

/// The table as a Markdown page: a section a group; rows of which the verdict is not the expected one are
/// marked.
std::string table_page(const std::vector<DecidedRow>& rows);

}  // namespace rederive
