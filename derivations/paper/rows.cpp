// equations.toml → rows. Every complaint names the file, the row and what would be right.
#include <derivations/paper/ledger.hpp>

#include <algorithm>
#include <set>
#include <stdexcept>
#include <toml++/toml.h>

namespace rederive {

namespace {

const std::set<std::string> keys{"id", "section", "kind", "printed", "latex", "domain", "follows_from", "expected",
                                 "error", "consequence", "note", "scan_repaired",
                                 "statement"};
const std::set<std::string> kinds{"equation", "inequality", "definition", "result"};
const std::set<std::string> verdicts{"proved", "proved_under", "approximation", "refuted", "definition", "undecided"};

std::string joined(const std::set<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

Row read_row(const toml::table& table, const std::string& where) {
  const auto fail = [&](const std::string& what) { throw std::runtime_error(where + ": " + what); };
  for (const auto& [key, value] : table)
    if (!keys.contains(std::string(key.str())))
      fail("unknown key '" + std::string(key.str()) + "'; the keys are " + joined(keys));
  const auto text = [&](const char* key) -> std::string {
    const auto* node = table.get(key);
    if (node == nullptr) return "";
    if (!node->is_string()) fail(std::string("'") + key + "' must be a string");
    return node->value_or(std::string());
  };
  Row row;
  row.id = text("id");
  row.section = text("section");
  row.kind = text("kind");
  row.printed = text("printed");
  row.statement = text("statement");
  row.latex = text("latex");
  row.domain = text("domain");
  row.expected = text("expected");
  row.error = text("error");
  row.consequence = text("consequence");
  row.note = text("note");
  row.scan_repaired = text("scan_repaired");
  if (const auto* sources = table["follows_from"].as_array())
    for (const auto& source : *sources) row.follows_from.push_back(source.value_or(std::string()));
  if (row.id.empty()) fail("a row needs an 'id' such as \"21a\"");
  if (!kinds.contains(row.kind)) fail("row " + row.id + ": the kind '" + row.kind + "' is none; right is one of " + joined(kinds));
  if (!verdicts.contains(row.expected)) fail("row " + row.id + ": '" + row.expected + "' is no verdict; right is one of " + joined(verdicts));
  if ((row.kind == "result") != !row.statement.empty())
    fail("row " + row.id + ": a row of kind 'result', and no other, has a 'statement' of ours");
  return row;
}

}  // namespace

std::filesystem::path equations_file() { return std::filesystem::path(REDERIVE_PAPER_FOLDER) / "equations.toml"; }

std::vector<Row> read_rows(const std::filesystem::path& file) {
  std::vector<Row> rows;
  std::set<std::string> ids;
  try {
    const toml::table document = toml::parse_file(file.string());
    const auto* list = document["equation"].as_array();
    if (list == nullptr) throw std::runtime_error(file.string() + ": no [[equation]] in it");
    for (const auto& entry : *list) {
      const std::string where = file.string() + ":" + std::to_string(entry.source().begin.line);
      if (!entry.is_table()) throw std::runtime_error(where + ": [[equation]] must be a table");
      rows.push_back(read_row(*entry.as_table(), where));
      if (!ids.insert(rows.back().id).second) throw std::runtime_error(where + ": the id " + rows.back().id + " stands twice");
    }
  } catch (const toml::parse_error& error) {
    throw std::runtime_error(file.string() + ":" + std::to_string(error.source().begin.line) + ": " +
                             std::string(error.description()));
  }
  for (const Row& row : rows)
    for (const std::string& source : row.follows_from)
      if (!ids.contains(source))
        throw std::runtime_error(file.string() + ": row " + row.id + " follows from " + source + ", which is no row");
  return rows;
}

}  // namespace rederive
