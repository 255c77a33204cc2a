// equations.toml → rows. Every complaint names the file, the row and what would be right.
#include <algorithm>
#include <derivations/emit/data_folder.hpp>
#include <derivations/paper/ledger.hpp>
#include <derivations/paper/toml_rows.hpp>
#include <set>
#include <stdexcept>

namespace rederive {

namespace {

const std::set<std::string> kinds{"equation", "inequality", "definition", "result"};
const std::set<std::string> verdicts{"proved",  "proved_under", "approximation",
                                     "refuted", "definition",   "undecided"};

std::string joined(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

Row read_row(TomlRow table) {
  Row row;
  row.id = table.text("id", true);
  row.section = table.text("section");
  row.kind = table.text("kind");
  row.printed = table.text("printed");
  row.statement = table.text("statement");
  row.latex = table.text("latex");
  row.domain = table.text("domain");
  row.expected = table.text("expected");
  row.error = table.text("error");
  row.consequence = table.text("consequence");
  row.note = table.text("note");
  row.scan_repaired = table.text("scan_repaired");
  row.follows_from = table.texts("follows_from");
  table.done();
  const std::string name = "row " + row.id + ": ";
  if (!kinds.contains(row.kind))
    table.fail(name + "the kind '" + row.kind + "' is none; right is one of " + joined(kinds));
  if (!verdicts.contains(row.expected))
    table.fail(name + "'" + row.expected + "' is no verdict; right is one of " + joined(verdicts));
  if ((row.kind == "result") != !row.statement.empty())
    table.fail(name + "a row of kind 'result', and no other, has a 'statement' of ours");
  return row;
}

}  // namespace

std::filesystem::path equations_file() { return data_folder() / "equations.toml"; }

std::vector<Row> read_rows(const std::filesystem::path& file) {
  std::vector<Row> rows;
  std::set<std::string> ids;
  for (const TomlRow& table : toml_rows(file, "equation")) {
    rows.push_back(read_row(table));
    if (!ids.insert(rows.back().id).second) table.fail("the id " + rows.back().id + " stands twice");
  }
  for (const Row& row : rows)
    for (const std::string& source : row.follows_from)
      if (!ids.contains(source))
        throw std::runtime_error(file.string() + ": row " + row.id + " follows from " + source +
                                 ", which is no row");
  return rows;
}

}  // namespace rederive
