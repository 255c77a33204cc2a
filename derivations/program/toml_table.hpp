// Reads TOML files strictly: an unknown key and a value of the wrong type are errors with file and line.
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <derivations/language/text.hpp>
#include <derivations/program/program.hpp>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rederive::program {

/// A table of a TOML file. A key is known once it was asked for. Every error is a BadInput that begins with
/// "FILE:LINE: ", the line of the key or value.
class TomlTable {
 public:
  /// A function that is applied to every text; what it throws becomes an error with the line of the text.
  using Filling = std::function<std::string(const std::string&)>;

  /// Reads a file; the table is the whole document. Throws BadInput.
  explicit TomlTable(const std::filesystem::path& file);

  /// Return the text of a key, "" if it is missing; `needed_text` throws if it is missing or empty.
  std::string text(const std::string& key) { return one<std::string>(key, "a string").value_or(""); }
  std::string needed_text(const std::string& key);
  /// Return a text on one line, without control characters.
  std::string line(const std::string& key);
  std::string needed_line(const std::string& key);
  /// Return one of the words; "" if the key is missing.
  std::string word(const std::string& key, const std::vector<std::string>& words);
  std::string needed_word(const std::string& key, const std::vector<std::string>& words);
  /// Returns the enumerator of one of the words, which are in the order of the enum from 0 on; the first one
  /// if the key is missing.
  template <class Enum>
  Enum needed_one_of(const std::string& key, const std::vector<std::string>& words) {
    const std::string found = needed_word(key, words);
    return found.empty() ? Enum{} : one_of<Enum>(key, found, words);
  }
  /// Returns a list of texts, empty if the key is missing.
  std::vector<std::string> texts(const std::string& key);
  /// Returns a list of texts on one line each, without control characters.
  std::vector<std::string> lines(const std::string& key);
  /// Returns a finite number.
  std::optional<double> number(const std::string& key);
  std::optional<std::int64_t> whole(const std::string& key, std::int64_t least, std::int64_t largest);
  bool flag(const std::string& key) { return one<bool>(key, "true or false").value_or(false); }
  /// Returns the table of a key.
  std::optional<TomlTable> table(const std::string& key);
  /// Returns the tables of a list [[key]], none if the key is missing.
  std::vector<TomlTable> tables(const std::string& key);
  /// Returns name → text for the table of a key. Names are filled in, too; empty names are left out.
  std::map<std::string, std::string> named_texts(const std::string& key);
  /// Returns the items of a list, each a text or a table of texts, as name → text. The name of a text alone
  /// is the key.
  std::vector<std::map<std::string, std::string>> alternatives(const std::string& key);
  /// Returns all keys in the order of the file.
  std::vector<std::string> keys() const;
  bool has(const std::string& key) const { return table_->contains(key); }

  /// Throws for a key that nobody asked for, then for a needed key that is missing.
  void done() const;
  /// Throws if a text is not one of the known words, and suggests the nearest one.
  void check_word(const std::string& key, const std::string& text,
                  const std::vector<std::string>& words) const;
  /// Returns the enumerator of a word, as `needed_one_of` does. Throws as `check_word` does.
  template <class Enum>
  Enum one_of(const std::string& key, const std::string& text, const std::vector<std::string>& words) const {
    check_word(key, text, words);
    return static_cast<Enum>(std::ranges::find(words, text) - words.begin());
  }
  /// Throws BadInput at the line of `key`, or of the table if the key is empty or missing.
  [[noreturn]] void fail(const std::string& what, const std::string& key = "") const;
  /// Returns "FILE:LINE" of a key, or of the table if the key is empty or missing.
  std::string where(const std::string& key = "") const {
    const toml::node* node = table_->get(key);
    return at((node == nullptr ? *table_ : *node).source());
  }

  /// Sets the name with which errors begin: "exercise first-lift".
  void call_it(const std::string& name) { name_ = name; }
  void fill_in(Filling filling) { filling_ = std::move(filling); }

 private:
  struct File {
    std::string name;
    toml::table document;
  };

  TomlTable(const TomlTable& parent, const toml::table& table)
      : file_(parent.file_), table_(&table), name_(parent.name_), filling_(parent.filling_) {}
  static File read(const std::filesystem::path& file);
  std::string at(const toml::source_region& source) const {
    return fmt::format("{}:{}", file_->name, source.begin.line);
  }
  [[noreturn]] void refuse(const toml::source_region& source, const std::string& what) const {
    throw BadInput(fmt::format("{}: {}{}{}", at(source), name_, name_.empty() ? "" : ": ", what));
  }
  std::string filled(const std::string& text, const toml::source_region& source) const;
  std::map<std::string, std::string> texts_in(const toml::table& table, const std::string& key) const;
  void check_line(const std::string& key, const std::string& text) const {
    if (printable_line(text) != text)
      fail(fmt::format("'{}' must be one line of printable characters", key), key);
  }
  std::string needed(const std::string& key, std::string found) {
    if (missing_.empty() && found.empty()) missing_ = key;
    return found;
  }

  template <class T>
  std::optional<T> one(const std::string& key, const char* right) {
    asked_.push_back(key);
    const toml::node* node = table_->get(key);
    if (node == nullptr) return std::nullopt;
    const auto found = node->value<T>();
    if (!found || node->is_boolean() != std::is_same_v<T, bool>) fail("'" + key + "' must be " + right, key);
    if constexpr (std::is_same_v<T, std::string>) return filled(*found, node->source());
    return found;
  }

  std::shared_ptr<const File> file_;
  const toml::table* table_;  ///< in the document of the file
  std::string name_, missing_;
  std::vector<std::string> asked_;
  Filling filling_;
};

/// Returns the tables [[name]] of a file that contains nothing else. Throws BadInput if it contains none.
std::vector<TomlTable> tables_of(const std::filesystem::path& file, const std::string& name);

inline TomlTable::File TomlTable::read(const std::filesystem::path& file) {
  constexpr std::size_t largest = 2'000'000, longest_line = 10'000;  // a key a.a.a… is as deep as it is long
  const std::string text = read_whole(file, {.most = largest}), name = printable_name(file);
  std::size_t line = 1;
  for (std::size_t begin = 0, end; begin < text.size(); begin = end + 1, ++line) {
    end = std::min(text.find('\n', begin), text.size());
    if (end - begin > longest_line)
      throw BadInput(fmt::format("{}:{}: a line has more than {} bytes", name, line, longest_line));
  }
  try {
    return {name, toml::parse(text)};
  } catch (const toml::parse_error& error) {
    throw BadInput(fmt::format("{}:{}: {}", name, error.source().begin.line, error.description()));
  }
}

inline TomlTable::TomlTable(const std::filesystem::path& file)
    : file_(std::make_shared<const File>(read(file))), table_(&file_->document) {}

inline std::string TomlTable::needed_text(const std::string& key) { return needed(key, text(key)); }

inline std::string TomlTable::needed_line(const std::string& key) { return needed(key, line(key)); }

inline std::string TomlTable::line(const std::string& key) {
  std::string found = text(key);
  check_line(key, found);
  return found;
}

inline std::vector<std::string> TomlTable::lines(const std::string& key) {
  std::vector<std::string> found = texts(key);
  for (const std::string& text : found) check_line(key, text);
  return found;
}

inline std::string TomlTable::word(const std::string& key, const std::vector<std::string>& words) {
  std::string found = text(key);
  if (has(key)) check_word(key, found, words);
  return found;
}

inline std::string TomlTable::needed_word(const std::string& key, const std::vector<std::string>& words) {
  return needed(key, word(key, words));
}

inline std::vector<std::string> TomlTable::texts(const std::string& key) {
  asked_.push_back(key);
  std::vector<std::string> items;
  const toml::node* node = table_->get(key);
  if (node == nullptr) return items;
  const toml::array* array = node->as_array();
  if (array == nullptr) fail("'" + key + "' must be a list of strings", key);
  for (const toml::node& item : *array) {
    if (!item.is_string()) refuse(item.source(), "'" + key + "' must be a list of strings");
    items.push_back(filled(item.as_string()->get(), item.source()));
  }
  return items;
}

inline std::optional<double> TomlTable::number(const std::string& key) {
  const auto found = one<double>(key, "a number");
  if (found && !std::isfinite(*found)) fail("'" + key + "' must be a finite number", key);
  return found;
}

inline std::optional<std::int64_t> TomlTable::whole(const std::string& key, std::int64_t least,
                                                    std::int64_t largest) {
  const auto found = one<std::int64_t>(key, "a whole number");
  if (found && (*found < least || *found > largest))
    fail(fmt::format("'{}' must be from {} to {}", key, least, largest), key);
  return found;
}

inline std::optional<TomlTable> TomlTable::table(const std::string& key) {
  asked_.push_back(key);
  const toml::node* node = table_->get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_table()) fail("'" + key + "' must be a table", key);
  return TomlTable(*this, *node->as_table());
}

inline std::vector<TomlTable> TomlTable::tables(const std::string& key) {
  asked_.push_back(key);
  std::vector<TomlTable> found;
  const toml::node* node = table_->get(key);
  if (node == nullptr) return found;
  const std::string right = "'" + key + "' must be a list of tables: [[" + key + "]]";
  if (!node->is_array()) fail(right, key);
  for (const toml::node& item : *node->as_array()) {
    if (!item.is_table()) refuse(item.source(), right);
    found.push_back(TomlTable(*this, *item.as_table()));
  }
  return found;
}

inline std::map<std::string, std::string> TomlTable::named_texts(const std::string& key) {
  asked_.push_back(key);
  const toml::node* node = table_->get(key);
  if (node == nullptr) return {};
  if (!node->is_table()) fail("'" + key + "' must be a table of strings, { name = \"text\" }", key);
  return texts_in(*node->as_table(), key);
}

inline std::vector<std::map<std::string, std::string>> TomlTable::alternatives(const std::string& key) {
  asked_.push_back(key);
  std::vector<std::map<std::string, std::string>> found;
  const toml::node* node = table_->get(key);
  const toml::array* list = node == nullptr ? nullptr : node->as_array();
  if (list == nullptr) fail("'" + key + "' must be a list of strings, or of tables of strings", key);
  for (const toml::node& item : *list)
    if (const toml::table* names = item.as_table())
      found.push_back(texts_in(*names, key));
    else if (const auto* text = item.as_string())
      found.push_back({{key, filled(text->get(), item.source())}});
    else
      refuse(item.source(), "'" + key + "' must be a list of strings, or of tables of strings");
  return found;
}

inline std::map<std::string, std::string> TomlTable::texts_in(const toml::table& table,
                                                              const std::string& key) const {
  std::map<std::string, std::string> found;
  for (const auto& [name, value] : table) {
    if (!value.is_string())
      refuse(name.source(), fmt::format("'{}' in '{}' must be a string", name.str(), key));
    const std::string named = filled(std::string(name.str()), name.source());
    if (named.empty()) continue;
    if (!found.emplace(named, filled(value.as_string()->get(), value.source())).second)
      refuse(name.source(), fmt::format("'{}' is in '{}' twice", named, key));
  }
  return found;
}

inline std::vector<std::string> TomlTable::keys() const {
  std::vector<std::string> all;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::string> by_place;
  for (const auto& [key, value] : *table_)
    by_place[{key.source().begin.line, key.source().begin.column}] = key.str();
  for (const auto& [place, name] : by_place) all.push_back(name);
  return all;
}

inline void TomlTable::done() const {
  for (const auto& [key, value] : *table_)
    if (const std::string name(key.str()); std::ranges::find(asked_, name) == asked_.end())
      refuse(key.source(),
             fmt::format("there is no key '{}' here{}; the keys are {}", name,
                         language::did_you_mean(language::nearest(name, asked_)), fmt::join(asked_, ", ")));
  if (!missing_.empty()) fail("'" + missing_ + "' is missing or empty", missing_);
}

inline void TomlTable::check_word(const std::string& key, const std::string& text,
                                  const std::vector<std::string>& words) const {
  constexpr std::size_t most_listed = 20;
  if (std::ranges::find(words, text) != words.end()) return;
  std::string right = language::did_you_mean(language::nearest(text, words));
  if (words.size() <= most_listed) right += fmt::format("; it must be one of {}", fmt::join(words, ", "));
  fail(fmt::format("'{}' cannot be '{}'{}", key, text, right), key);
}

inline void TomlTable::fail(const std::string& what, const std::string& key) const {
  throw BadInput(fmt::format("{}: {}{}{}", where(key), name_, name_.empty() ? "" : ": ", what));
}

inline std::string TomlTable::filled(const std::string& text, const toml::source_region& source) const {
  if (!filling_) return text;
  try {
    return filling_(text);
  } catch (const std::runtime_error& error) {
    refuse(source, error.what());
  }
}

inline std::vector<TomlTable> tables_of(const std::filesystem::path& file, const std::string& name) {
  TomlTable document(file);
  std::vector<TomlTable> found = document.tables(name);
  document.done();
  if (found.empty()) document.fail("there is no [[" + name + "]] in this file");
  return found;
}

}  // namespace rederive::program
