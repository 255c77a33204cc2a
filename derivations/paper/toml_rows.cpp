#include <fmt/format.h>

#include <derivations/emit/program.hpp>
#include <derivations/paper/toml_rows.hpp>

namespace rederive {

std::string TomlRow::text(const std::string& key, bool is_needed) {
  const auto found = value<std::string>(key, "a string");
  if (is_needed && missing_.empty() && found.value_or("").empty()) missing_ = key;
  return found.value_or("");
}

std::vector<std::string> TomlRow::texts(const std::string& key) {
  asked_.insert(key);
  std::vector<std::string> items;
  const toml::node* node = table_.get(key);
  if (node == nullptr) return items;
  const toml::array* array = node->as_array();
  if (array == nullptr || (!array->empty() && !array->is_homogeneous(toml::node_type::string)))
    fail("'" + key + "' must be a list of strings");
  for (const toml::node& item : *array) items.push_back(item.value_or(std::string()));
  return items;
}

void TomlRow::done() const {
  for (const auto& [key, value] : table_)
    if (!asked_.contains(std::string(key.str())))
      fail(fmt::format("unknown key '{}'; the keys are {}", key.str(), fmt::join(asked_, ", ")));
  if (!missing_.empty()) fail("a row needs '" + missing_ + "'");
}

void TomlRow::fail(const std::string& what) const { throw BadInput(where_ + ": " + what); }

std::vector<TomlRow> toml_rows(const std::filesystem::path& file, const std::string& name) {
  const auto at = [&](const toml::source_region& source) {
    return fmt::format("{}:{}", file.string(), source.begin.line);
  };
  std::vector<TomlRow> rows;
  try {
    const toml::table document = toml::parse_file(file.string());
    const toml::array* list = document[name].as_array();
    if (list == nullptr) throw BadInput("'" + file.string() + "' has no [[" + name + "]] in it");
    for (const toml::node& node : *list) {
      if (!node.is_table()) throw BadInput(at(node.source()) + ": [[" + name + "]] must be a table");
      rows.emplace_back(*node.as_table(), at(node.source()));
    }
  } catch (const toml::parse_error& error) {
    throw BadInput(at(error.source()) + ": " + std::string(error.description()));
  }
  return rows;
}

}  // namespace rederive
