#include <fmt/format.h>

#include <algorithm>
#include <derivations/program/toml_table.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <map>
#include <nlohmann/json.hpp>

namespace rederive::ledger {
using namespace language;
using namespace decide;
using namespace program;
using namespace paper;

namespace {

using Json = nlohmann::ordered_json;

constexpr auto refused = "refused";  ///< what is expected of an input that cannot be used

TableRow read_row(TomlTable& table) {
  std::vector<std::string> verdicts{refused};
  for (const Verdict verdict :
       {Verdict::proved, Verdict::proved_under, Verdict::approximation, Verdict::refuted, Verdict::undecided})
    verdicts.push_back(to_string(verdict));
  TableRow row;
  row.group = table.needed_line("group");
  row.why = table.line("why");
  row.expected = table.needed_word("expected", verdicts);
  row.limit = table.flag("limit");
  row.request.left = table.needed_line("left");
  row.request.right = table.needed_line("right");
  row.request.assumptions = table.lines("assume");
  row.request.small = table.lines("small");
  if (const auto order = table.whole("order", 0, 12)) row.request.order = static_cast<int>(*order);
  table.done();
  return row;
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
  std::vector<std::string> cells;
  for (const std::string& assumption : request.assumptions) cells.push_back(cell(assumption));
  if (request.order)
    cells.push_back(fmt::format("{} small, order {}", cell(fmt::format("{}", fmt::join(request.small, ", "))),
                                *request.order));
  return fmt::format("{}", fmt::join(cells, ", "));
}

}  // namespace

std::vector<TableRow> read_table(const std::filesystem::path& file) {
  std::vector<TableRow> rows;
  for (TomlTable& table : tables_of(file, "row")) rows.push_back(read_row(table));
  return rows;
}

std::vector<DecidedRow> decide_table(const Paper& paper, const std::vector<TableRow>& rows) {
  std::vector<DecidedRow> decided;
  for (const TableRow& row : rows) {
    if (is_lively(2)) fmt::print(stderr, "\r{} of {}", decided.size() + 1, rows.size());
    try {
      const auto proof = decide_bounded(paper, row.request);
      decided.push_back({row, proof["verdict"], proof["reason"].is_string() ? proof["reason"] : ""});
    } catch (const BadInput& error) {
      decided.push_back({row, refused, error.what()});
    }
  }
  if (is_lively(2)) fmt::print(stderr, "\r{:20}\r", "");
  return decided;
}

Json to_json(const std::vector<DecidedRow>& rows) {
  Json list = Json::array(), counts = Json::object();
  for (const auto& [row, verdict, reason] : rows) {
    const ProveRequest& asked = row.request;
    list.push_back({{"group", row.group},
                    {"left", asked.left},
                    {"right", asked.right},
                    {"assume", asked.assumptions},
                    {"small", asked.small},
                    {"order", asked.order ? Json(*asked.order) : Json()},
                    {"verdict", verdict},
                    {"expected", row.expected},
                    {"limit", row.limit},
                    {"reason", reason}});
    counts[verdict] = counts.value(verdict, 0) + 1;
  }
  return {{"rows", list}, {"counts", counts}};
}

std::string table_page(const std::vector<DecidedRow>& rows) {
  std::map<std::string, int> counts;
  std::vector<std::pair<std::string, std::string>> groups;  // in the order of their first rows
  for (const auto& [row, verdict, reason] : rows) {
    auto group = std::find_if(groups.begin(), groups.end(),
                              [&row = row](const auto& g) { return g.first == row.group; });
    if (group == groups.end())
      group = groups.insert(
          group,
          {row.group, "| left | right | assumed | verdict | why it is here |\n|---|---|---|---|---|\n"});
    ++counts[row.limit && verdict == to_string(Verdict::undecided) ? "undecided, though true" : verdict];
    group->second += fmt::format("| {} | {} | {} | {}{} | {} |\n", cell(row.request.left),
                                 cell(row.request.right), assumptions(row.request), verdict,
                                 verdict == row.expected ? "" : " (**expected " + row.expected + "**)",
                                 escaped(row.why, "|*_`"));
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

}  // namespace rederive::ledger
