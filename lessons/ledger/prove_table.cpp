#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <derivations/command_line.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <map>

namespace rederive {

namespace {

std::string text(const toml::table& row, const char* key) { return row[key].value_or(std::string()); }

std::vector<std::string> list(const toml::table& row, const char* key) {
  std::vector<std::string> items;
  if (const toml::array* array = row[key].as_array())
    for (const toml::node& item : *array) items.push_back(item.value_or(std::string()));
  return items;
}

/// A text in which some characters mean nothing to Markdown.
std::string escaped(std::string text, const char* characters) {
  for (std::size_t k = 0; (k = text.find_first_of(characters, k)) != std::string::npos; k += 2)
    text.insert(k, "\\");
  return text;
}

/// A formula in a cell of a Markdown table.
std::string cell(const std::string& formula) { return "`" + escaped(formula, "|") + "`"; }

std::string assumptions(const ProveRequest& request) {
  std::string result;
  for (const std::string& assumption : request.assumptions)
    result += (result.empty() ? "" : ", ") + cell(assumption);
  if (request.order) {
    std::string small;
    for (const std::string& name : request.small) small += (small.empty() ? "" : ", ") + name;
    result += fmt::format("{} small, order {}", cell(small), *request.order);
  }
  return result;
}

}  // namespace

std::vector<TableRow> read_table(const std::filesystem::path& file) {
  std::vector<TableRow> rows;
  try {
    const toml::table table = toml::parse_file(file.string());
    const toml::array* array = table["row"].as_array();
    if (array == nullptr) throw BadInput("'" + file.string() + "' has no [[row]]");
    for (const toml::node& node : *array) {
      if (!node.is_table())
        throw BadInput(fmt::format("{}:{}: a row is a table", file.string(), node.source().begin.line));
      const toml::table& row = *node.as_table();
      TableRow entry{
          text(row, "group"), text(row, "why"), text(row, "expected"), row["limit"].value_or(false), {}};
      entry.request = {text(row, "left"), text(row, "right"), list(row, "assume"), list(row, "small"),
                       row["order"].value<int>()};
      if (entry.expected.empty() || entry.group.empty())
        throw BadInput(fmt::format("{}:{}: a row needs left, right, group and expected", file.string(),
                                   node.source().begin.line));
      rows.push_back(std::move(entry));
    }
  } catch (const toml::parse_error& error) {
    throw BadInput(fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
  return rows;
}

std::string verdict_of(const TableRow& row) {
  try {
    return to_string(decide(row.request).proof.verdict);
  } catch (const BadInput&) {
    return "refused";
  }
}

std::string table_page(const std::vector<TableRow>& rows, int& unexpected) {
  std::map<std::string, int> counts;
  std::vector<std::pair<std::string, std::string>> groups;  // in the order of their first rows
  for (const TableRow& row : rows) {
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == row.group; });
    if (group == groups.end())
      group = groups.insert(
          group,
          {row.group, "| left | right | assumed | verdict | why it is here |\n|---|---|---|---|---|\n"});
    const std::string verdict = verdict_of(row);
    ++counts[row.limit && verdict == "undecided" ? "undecided, though true" : verdict];
    const bool as_expected = verdict == row.expected;
    unexpected += as_expected ? 0 : 1;
    group->second +=
        fmt::format("| {} | {} | {} | {}{} | {} |\n", cell(row.request.left), cell(row.request.right),
                    assumptions(row.request), verdict,
                    as_expected ? "" : " (**expected " + row.expected + "**)", escaped(row.why, "|*_`"));
  }
  std::string head = fmt::format(
      "# What `ledger prove` can decide, and what it cannot\n\n{} statements, decided as this page was "
      "written:",
      rows.size());
  for (const auto& [verdict, count] : counts) head += fmt::format(" {} {},", count, verdict);
  head.back() = '.';
  head += "\n";
  for (const auto& [name, body] : groups) head += fmt::format("\n## {}\n\n{}", name, body);
  return head;
}

}  // namespace rederive
