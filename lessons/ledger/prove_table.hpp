// A table of statements with the verdict that is expected of each: what the engine can do, and what it
// cannot.
#pragma once

#include <filesystem>
#include <lessons/ledger/prove_command.hpp>

namespace rederive {

struct TableRow {
  std::string group, why;  ///< the heading it stands under, and why it is there
  std::string expected;    ///< a verdict, or "refused" for an input that cannot be used
  bool limit = false;      ///< a known limit: the statement is true, and the engine says undecided
  ProveRequest request;
};

/// Reads a table such as tests/prove_table.toml. Throws BadInput naming what is wrong and where.
std::vector<TableRow> read_table(const std::filesystem::path& file);

/// The verdict, computed now: "proved", …, or "refused".
std::string verdict_of(const TableRow& row);

/// The table as a Markdown page: a section a group, with the verdicts computed now; `unexpected` counts rows
/// whose verdict is not the expected one (they are marked).
std::string table_page(const std::vector<TableRow>& rows, int& unexpected);

}  // namespace rederive
