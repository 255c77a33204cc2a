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
  Reader(const toml::table& table, std::string where, const Choice& choice)
      : table_(table), where_(std::move(where)), choice_(choice) {}

  std::string text(const std::string& key, bool needed = false) {
    const auto* node = find(key, needed);
    if (node == nullptr) return "";
    if (node->is_string()) return filled(*node);
    fail("'" + key + "' must be text");
  }
  double number(const std::string& key) {
    const auto* node = find(key, false);
    return node == nullptr ? 0 : node->value_or(0.0);
  }
  std::vector<std::string> texts(const std::string& key) {
    std::vector<std::string> result;
    if (const auto* node = find(key, false))
      for (const auto& item : *array(*node, key)) result.push_back(filled(item));
    return result;
  }
  std::map<std::string, std::string> pairs(const std::string& key) {
    std::map<std::string, std::string> result;
    if (const auto* node = find(key, false))
      for (const auto& [name, value] : *sub(*node, key))
        result[filled(toml::value(std::string(name.str())))] = filled(value);
    return result;
  }
  std::map<std::string, double> numbers(const std::string& key) {
    std::map<std::string, double> result;
    if (const auto* node = find(key, false))
      for (const auto& [name, value] : *sub(*node, key))
        result[std::string(name.str())] = value.is_string() ? std::stod(filled(value)) : value.value_or(0.0);
    return result;
  }
  std::vector<Reader> readers(const std::string& key) {
    std::vector<Reader> result;
    if (const auto* node = find(key, false))
      for (const auto& item : *array(*node, key))
        result.emplace_back(*item.as_table(), where_ + ", " + key, choice_);
    return result;
  }
  std::optional<Reader> reader(const std::string& key) {
    const auto* node = find(key, false);
    if (node == nullptr) return {};
    return Reader(*sub(*node, key), where_ + ", " + key, choice_);
  }
  void is_read(const std::string& key) { asked_.insert(key); }
  /// Throws if there is a key that nobody asked for.
  void done() const {
    for (const auto& [key, value] : table_)
      if (!asked_.contains(std::string(key.str()))) fail("unknown key '" + std::string(key.str()) + "'");
  }
  [[noreturn]] void fail(const std::string& why) const { throw std::runtime_error(where_ + ": " + why); }

 private:
  std::string filled(const toml::node& node) const {
    try {
      return classroom::filled(node.value_or(std::string()), choice_);
    } catch (const std::exception& error) {
      fail(error.what());
    }
  }
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
  const Choice& choice_;
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
  if (const auto slip = reader.text("slip"); !slip.empty()) result.slip = std::stoul(slip);
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

/// By the seed, one entry of each list of `vary`: a text, or names that go together.
Choice chosen(const toml::table& exercise, const std::string& id, const std::string& seed) {
  Choice choice;
  if (const auto* lists = exercise["vary"].as_table())
    for (const auto& [key, list] : *lists) {
      std::vector<Choice> cases;
      for (const auto& item : *list.as_array()) {
        std::vector<Choice> expanded(1);
        const auto add = [&](std::string_view name, const toml::node& value) {
          const auto values = values_of(value.value_or(std::string()));
          expanded.resize(values.size(), expanded[0]);  // one range in a table
          for (std::size_t k = 0; k < expanded.size(); ++k) expanded[k][std::string(name)] = values[k];
        };
        if (const auto* names = item.as_table())
          for (const auto& [name, value] : *names) add(name.str(), value);
        else
          add(key.str(), item);
        cases.insert(cases.end(), expanded.begin(), expanded.end());
      }
      choice.merge(cases.at(picked(seed, id + "/" + std::string(key.str()), cases.size())));
    }
  return choice;
}

Exercise read_exercise(const toml::table& table, const std::string& file, const std::string& seed) {
  const std::string id = table["id"].value_or(std::string("without id"));
  Exercise exercise;
  exercise.choice = chosen(table, id, seed);
  if (!exercise.choice.empty()) exercise.seed = seed;
  Reader reader(table, file + ", exercise " + id, exercise.choice);
  reader.is_read("vary");
  exercise.id = reader.text("id", true);
  exercise.lesson = static_cast<int>(reader.number("lesson"));
  exercise.title = reader.text("title", true);
  exercise.kind = kind_of(reader.text("kind", true), reader);
  exercise.statement = reader.text("statement", true);
  exercise.symbols = reader.texts("symbols");
  exercise.range = reader.pairs("range");
  exercise.example = reader.text("example");
  exercise.name = reader.text("name");
  exercise.pivot = reader.text("pivot");
  exercise.unit = reader.text("unit");
  if (const double digits = reader.number("digits"); digits > 0) exercise.digits = static_cast<int>(digits);
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

std::vector<Exercise> read_exercises(const std::filesystem::path& folder, const std::string& seed) {
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
      exercises.push_back(read_exercise(*item.as_table(), name, seed));
      if (!ids.insert(exercises.back().id).second)
        throw std::runtime_error(name + ": a second exercise " + exercises.back().id);
    }
  }
  return exercises;
}

std::filesystem::path exercises_folder() { return REDERIVE_EXERCISES_FOLDER; }

}  // namespace rederive::classroom
