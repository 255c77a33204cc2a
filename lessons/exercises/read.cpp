// lessons/exercises/*.toml → exercises; what is missing or misspelt is said with file and exercise.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <lessons/exercises/exercise.hpp>
#include <set>
#include <stdexcept>

namespace rederive::classroom {
namespace {

/// A table whose keys are checked off as they are read, so that a misspelt one is noticed.
class Reader {
 public:
  Reader(const toml::table& table, std::string where) : table_(table), where_(std::move(where)) {}

  std::string text(const std::string& key, bool needed = false) {
    const auto* node = find(key, needed);
    if (node == nullptr) return "";
    if (const auto value = node->value<std::string>()) return *value;
    fail("'" + key + "' must be text");
  }
  double number(const std::string& key) {
    const auto* node = find(key, false);
    return node == nullptr ? 0 : node->value_or(0.0);
  }
  std::vector<std::string> texts(const std::string& key) {
    std::vector<std::string> result;
    if (const auto* node = find(key, false))
      for (const auto& item : *array(*node, key)) result.push_back(item.value_or(std::string()));
    return result;
  }
  std::map<std::string, std::string> pairs(const std::string& key) {
    std::map<std::string, std::string> result;
    if (const auto* node = find(key, false))
      for (const auto& [name, value] : *sub(*node, key))
        result[std::string(name.str())] = value.value_or(std::string());
    return result;
  }
  std::map<std::string, double> numbers(const std::string& key) {
    std::map<std::string, double> result;
    if (const auto* node = find(key, false))
      for (const auto& [name, value] : *sub(*node, key))
        result[std::string(name.str())] = value.value_or(0.0);
    return result;
  }
  std::vector<Reader> readers(const std::string& key) {
    std::vector<Reader> result;
    if (const auto* node = find(key, false))
      for (const auto& item : *array(*node, key)) result.emplace_back(*item.as_table(), where_ + ", " + key);
    return result;
  }
  std::optional<Reader> reader(const std::string& key) {
    const auto* node = find(key, false);
    if (node == nullptr) return {};
    return Reader(*sub(*node, key), where_ + ", " + key);
  }
  /// Throws if there is a key that nobody asked for.
  void done() const {
    for (const auto& [key, value] : table_)
      if (!asked_.contains(std::string(key.str()))) fail("unknown key '" + std::string(key.str()) + "'");
  }
  [[noreturn]] void fail(const std::string& why) const { throw std::runtime_error(where_ + ": " + why); }

 private:
  const toml::node* find(const std::string& key, bool needed) {
    asked_.insert(key);
    const auto* node = table_.get(key);
    if (node == nullptr && needed) fail("'" + key + "' is missing");
    return node;
  }
  const toml::array* array(const toml::node& node, const std::string& key) const {
    if (node.as_array() == nullptr) fail("'" + key + "' must be a list");
    return node.as_array();
  }
  const toml::table* sub(const toml::node& node, const std::string& key) const {
    if (node.as_table() == nullptr) fail("'" + key + "' must be a table");
    return node.as_table();
  }

  const toml::table& table_;
  std::string where_;
  std::set<std::string> asked_;
};

Kind kind_of(const std::string& name, const Reader& reader) {
  static const std::map<std::string, Kind> kinds{{"expression", Kind::expression},
                                                 {"equation", Kind::equation},
                                                 {"number", Kind::number},
                                                 {"choice", Kind::choice},
                                                 {"wrong_term", Kind::wrong_term}};
  const auto found = kinds.find(name);
  if (found == kinds.end())
    reader.fail("kind '" + name + "' is none of expression, equation, number, choice, wrong_term");
  return found->second;
}

Reference read_reference(Reader reader) {
  Reference result;
  result.derivation = reader.text("derivation");
  result.row = reader.text("row");
  result.function = reader.text("function");
  if (const auto side = reader.text("side"); !side.empty()) result.side = side;
  result.solve_for = reader.text("solve_for");
  result.put = reader.pairs("put");
  result.differentiate = reader.text("differentiate");
  result.arguments = reader.numbers("arguments");
  const int given = !result.derivation.empty() + !result.row.empty() + !result.function.empty();
  if (given != 1) reader.fail("exactly one of derivation, row and function is wanted");
  reader.done();
  return result;
}

Slip read_slip(Reader reader) {
  Slip slip{reader.text("note", true),
            reader.text("says", true),
            {},
            reader.text("typed"),
            reader.text("hint", true)};
  if (auto road = reader.reader("road")) slip.road = read_reference(*road);
  if (slip.road.has_value() == !slip.typed.empty()) reader.fail("either road or typed is wanted");
  reader.done();
  return slip;
}

Exercise read_exercise(Reader reader) {
  Exercise exercise;
  exercise.id = reader.text("id", true);
  exercise.lesson = static_cast<int>(reader.number("lesson"));
  exercise.title = reader.text("title", true);
  exercise.kind = kind_of(reader.text("kind", true), reader);
  exercise.statement = reader.text("statement", true);
  exercise.symbols = reader.texts("symbols");
  exercise.range = reader.pairs("range");
  exercise.example = reader.text("example");
  exercise.form = reader.text("form");
  exercise.name = reader.text("name");
  exercise.pivot = reader.text("pivot");
  exercise.unit = reader.text("unit");
  exercise.tolerance = reader.number("tolerance");
  exercise.digits = static_cast<int>(reader.number("digits"));
  exercise.hints = reader.texts("hints");
  exercise.equivalents = reader.texts("equivalents");
  if (auto answer = reader.reader("answer"))
    exercise.answer = read_reference(*answer);
  else
    reader.fail("'answer' is missing");
  for (auto& slip : reader.readers("slip")) exercise.slips.push_back(read_slip(slip));
  for (auto& option : reader.readers("option")) {
    exercise.options.push_back({option.text("text", true), option.text("claim", true), option.text("note"),
                                option.text("says"), option.text("hint")});
    option.done();
  }
  for (auto& assumption : reader.readers("assumption")) {
    exercise.assumptions.push_back({assumption.pairs("put"), assumption.text("says", true)});
    assumption.done();
  }
  reader.done();
  return exercise;
}

}  // namespace

std::vector<Exercise> read_exercises(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& file : std::filesystem::directory_iterator(folder))
    if (file.path().extension() == ".toml" && file.path().filename() != "slips.toml")
      files.push_back(file.path());
  std::sort(files.begin(), files.end());
  std::vector<Exercise> exercises;
  std::set<std::string> ids;
  for (const auto& file : files) {
    const std::string name = file.filename().string();
    toml::table table;
    try {
      table = toml::parse_file(file.string());
    } catch (const toml::parse_error& error) {
      throw std::runtime_error(
          fmt::format("{}, line {}: {}", name, error.source().begin.line, error.description()));
    }
    const auto* list = table["exercise"].as_array();
    if (list == nullptr) throw std::runtime_error(name + ": no [[exercise]]");
    for (const auto& item : *list) {
      const std::string id = (*item.as_table())["id"].value_or(std::string("without id"));
      exercises.push_back(read_exercise(Reader(*item.as_table(), name + ", exercise " + id)));
      if (!ids.insert(id).second) throw std::runtime_error(name + ": a second exercise " + id);
    }
  }
  return exercises;
}

std::filesystem::path exercises_folder() { return REDERIVE_EXERCISES_FOLDER; }

}  // namespace rederive::classroom
