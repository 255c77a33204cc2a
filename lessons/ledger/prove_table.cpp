#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <derivations/emit/command_line.hpp>
#include <lessons/ledger/prove_table.hpp>
#include <map>
#include <set>

namespace rederive {

namespace {

using Json = nlohmann::ordered_json;

const std::set<std::string> verdicts{"proved",  "proved_under", "approximation",
                                     "refuted", "undecided",    "refused"};

/// A row of the table, of which every complaint names the file, the line and what would be right.
class RowReader {
 public:
  RowReader(const toml::node& node, const std::filesystem::path& file)
      : row_(node.as_table()), where_(fmt::format("{}:{}", file.string(), node.source().begin.line)) {
    if (row_ == nullptr) fail("a row is a table");
    const std::set<std::string> keys{"group", "left",  "right", "assume",  "small",
                                     "order", "limit", "why",   "expected"};
    for (const auto& [key, value] : *row_)
      if (!keys.contains(std::string(key.str())))
        fail(fmt::format("unknown key '{}'; the keys are {}", key.str(), fmt::join(keys, ", ")));
  }

  TableRow read() const {
    TableRow row{text("group", true),
                 text("why", false),
                 text("expected", true),
                 value<bool>("limit", "true or false").value_or(false),
                 {}};
    row.request = {text("left", true), text("right", true), list("assume"), list("small"), {}};
    if (const auto order = value<std::int64_t>("order", "a whole number")) {
      if (*order < 0 || *order > 12) fail("'order' is 0 to 12");
      row.request.order = static_cast<int>(*order);
    }
    if (!verdicts.contains(row.expected))
      fail(fmt::format("'{}' is no verdict; right is one of {}", row.expected, fmt::join(verdicts, ", ")));
    return row;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw BadInput(where_ + ": " + what); }

  template <class T>
  std::optional<T> value(const char* key, const char* right) const {
    const toml::node* node = row_->get(key);
    if (node == nullptr) return std::nullopt;
    const auto found = node->value_exact<T>();
    if (!found) fail(fmt::format("'{}' must be {}", key, right));
    return found;
  }

  std::string text(const char* key, bool is_needed) const {
    const auto found = value<std::string>(key, "a string");
    if (!found && is_needed) fail(fmt::format("a row needs '{}'", key));
    return line(found.value_or(""), key);
  }

  std::string line(std::string text, const char* key) const {
    if (printable_line(text) != text) fail(fmt::format("'{}' is one line of printable characters", key));
    return text;
  }

  std::vector<std::string> list(const char* key) const {
    std::vector<std::string> items;
    const toml::node* node = row_->get(key);
    if (node == nullptr) return items;
    const toml::array* array = node->as_array();
    if (array == nullptr || !array->is_homogeneous(toml::node_type::string))
      fail(fmt::format("'{}' must be a list of strings", key));
    for (const toml::node& item : *array) items.push_back(line(item.value_or(std::string()), key));
    return items;
  }

  const toml::table* row_;
  std::string where_;
};

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
    result += fmt::format("{}{} small, order {}", result.empty() ? "" : ", ", cell(small), *request.order);
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
    for (const toml::node& node : *array) rows.push_back(RowReader(node, file).read());
  } catch (const toml::parse_error& error) {
    throw BadInput(fmt::format("{}:{}: {}", file.string(), error.source().begin.line, error.description()));
  }
  return rows;
}

std::vector<DecidedRow> decide_table(const std::vector<TableRow>& rows) {
  std::vector<DecidedRow> decided;
  for (const TableRow& row : rows) {
    if (is_lively(2)) fmt::print(stderr, "\r{} of {}", decided.size() + 1, rows.size());
    try {
      const auto [proof, certificate] = decide_bounded(row.request);
      decided.push_back({row, proof["verdict"], proof["reason"].is_string() ? proof["reason"] : ""});
    } catch (const BadInput& error) {
      decided.push_back({row, "refused", error.what()});
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
    auto group =
        std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == row.group; });
    if (group == groups.end())
      group = groups.insert(
          group,
          {row.group, "| left | right | assumed | verdict | why it is here |\n|---|---|---|---|---|\n"});
    ++counts[row.limit && verdict == "undecided" ? "undecided, though true" : verdict];
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

}  // namespace rederive
