#include <toml++/toml.h>

#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <tests/cases.hpp>

namespace {

void add(const toml::node& node, Cells& cells) {
  if (const toml::array* list = node.as_array()) {
    for (const toml::node& item : *list) add(item, cells);
  } else if (const auto* text = node.as_string()) {
    cells.push_back(**text);
  } else {
    std::ostringstream shown;
    node.visit([&](const auto& value) { shown << value; });
    cells.push_back(shown.str());
  }
}

}  // namespace

std::vector<Cells> cases(const std::string& section, const char* file) {
  const std::string table = std::filesystem::path(file).replace_extension(".toml");
  const toml::table document = toml::parse_file(table);
  const toml::array* rows = document[section].as_array();
  if (rows == nullptr || rows->empty()) throw std::runtime_error(table + " has no rows of '" + section + "'");
  std::vector<Cells> result;
  for (const toml::node& row : *rows) add(row, result.emplace_back());
  return result;
}

std::map<std::string, Cells> named_cases(const std::string& section, const char* file) {
  std::map<std::string, Cells> result;
  for (const Cells& row : cases(section, file)) result[row[0]] = rest(row, 1);
  return result;
}

std::string in_one_line(const Cells& cells) {
  std::string line;
  for (const std::string& cell : cells) line += (line.empty() ? "" : " | ") + cell;
  return line;
}
