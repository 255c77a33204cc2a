// Lists of tables in TOML files: rows of the ledger, claims, statements. Every complaint names the file, the
// line and what would be right.
#pragma once

#include <toml++/toml.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rederive {

/// One table of a list. A key counts as known once it was asked for. All throw BadInput.
class TomlRow {
 public:
  TomlRow(const toml::table& table, std::string where) : table_(table), where_(std::move(where)) {}

  /// What stands under a key: nothing, or not what is wanted, is refused or comes out empty.
  std::string text(const std::string& key, bool is_needed = false);
  std::vector<std::string> texts(const std::string& key);
  double number(const std::string& key) { return value<double>(key, "a number").value_or(0); }
  bool flag(const std::string& key) { return value<bool>(key, "true or false").value_or(false); }
  std::optional<std::int64_t> whole(const std::string& key) {
    return value<std::int64_t>(key, "a whole number");
  }

  /// Refuses a key that nobody asked for, then a text that is needed and missing.
  void done() const;
  [[noreturn]] void fail(const std::string& what) const;

 private:
  template <class T>
  std::optional<T> value(const std::string& key, const char* right) {
    asked_.insert(key);
    const toml::node* node = table_.get(key);
    if (node == nullptr) return std::nullopt;
    const auto found = node->value<T>();
    if (!found || node->is_boolean() != std::is_same_v<T, bool>) fail("'" + key + "' must be " + right);
    return found;
  }

  toml::table table_;
  std::string where_, missing_;
  std::set<std::string> asked_;
};

/// The tables of the list `name` in a file, in their order. Throws BadInput if the file cannot be
/// read.
std::vector<TomlRow> toml_rows(const std::filesystem::path& file, const std::string& name);

}  // namespace rederive
