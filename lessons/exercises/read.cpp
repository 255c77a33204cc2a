// lessons/exercises/*.toml → exercises; what is missing or misspelt is said with file and exercise.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <derivations/emit/data_folder.hpp>
#include <derivations/emit/program.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/paper/toml_rows.hpp>
#include <lessons/exercises/exercise.hpp>
#include <set>

namespace rederive::classroom {
namespace {

using Texts = std::map<std::string, std::string>;

/// Fills in the braces of all texts, and of the names in tables.
void fill_in(toml::node& node, const Choice& choice) {
  if (auto* text = node.as_string()) *text = filled(text->get(), choice);
  if (auto* list = node.as_array())
    for (auto& item : *list) fill_in(item, choice);
  if (auto* table = node.as_table()) {
    toml::table renamed;
    for (auto&& [name, value] : *table) {
      fill_in(value, choice);
      renamed.insert(filled(std::string(name.str()), choice), value);
    }
    *table = std::move(renamed);
  }
}

/// Takes out of a table the tables that stand under a key: one, or a list of them.
std::vector<toml::table> taken(toml::table& from, std::string_view key) {
  std::vector<toml::table> parts;
  if (const auto* one = from[key].as_table()) parts.push_back(*one);
  if (const auto* list = from[key].as_array())
    for (const auto& item : *list)
      if (item.is_table()) parts.push_back(*item.as_table());
  if (!parts.empty()) from.erase(key);
  return parts;
}

/// What is named in such a table, by name; an empty name stands for nothing.
Texts texts_taken(toml::table& from, std::string_view key) {
  Texts texts;
  for (const auto& part : taken(from, key))
    for (const auto& [name, value] : part)
      if (!name.str().empty()) texts[std::string(name.str())] = value.value_or(std::string());
  return texts;
}

/// What is written as a text, and must be a number.
template <class Number>
Number number_in(const std::string& text, const std::string& name, const std::string& where) {
  Number value{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size())
    throw BadInput(fmt::format("{}: {} = \"{}\" is no number", where, name, text));
  return value;
}

Reference read_reference(toml::table table, const std::string& where) {
  Reference result;
  result.put = texts_taken(table, "put");
  for (const auto& [name, text] : texts_taken(table, "arguments"))
    result.arguments[name] = number_in<double>(text, name, where);
  TomlRow row(table, where + ", answer");
  result.derivation = row.text("derivation");
  result.row = row.text("row");
  if (const auto slip = row.text("slip"); !slip.empty())
    result.slip = number_in<std::size_t>(slip, "slip", where);
  result.function = row.text("function");
  if (const auto side = row.text("side"); !side.empty()) result.side = side;
  result.solve_for = row.text("solve_for");
  result.differentiate = row.text("differentiate");
  row.done();
  const int given = !result.derivation.empty() + !result.row.empty() + !result.function.empty();
  if (given != 1) row.fail("exactly one of derivation, row and function is wanted");
  return result;
}

Slip read_slip(toml::table table, const std::string& where) {
  const auto road = taken(table, "road");
  TomlRow row(table, where + ", slip");
  Slip slip{row.text("note", true), row.text("says", true), {}, row.text("typed"), row.text("hint", true)};
  row.done();
  if (!road.empty()) slip.road = read_reference(road.front(), where);
  if (slip.road.has_value() == !slip.typed.empty()) row.fail("either road or typed is wanted");
  return slip;
}

/// By the seed, one entry of each list of `vary`: a text, or names that go together.
Choice chosen(const toml::table& exercise, const std::string& id, const std::string& seed) {
  Choice choice;
  if (const auto* lists = exercise["vary"].as_table())
    for (const auto& [key, list] : *lists) {
      std::vector<Choice> cases;
      const auto* items = list.as_array();
      if (items == nullptr || items->empty())
        throw BadInput(fmt::format("vary.{} must be a list with something in it", key.str()));
      for (const auto& item : *items) {
        std::vector<Choice> expanded(1);
        const auto add = [&](const std::string& name, const toml::node& value) {
          const auto text = value.value_or(std::string());
          if (text.find_first_of("{}") != std::string::npos)
            throw BadInput(fmt::format("vary.{}: '{}' must be a text without braces", key.str(), text));
          const auto values = values_of(text);
          if (values.size() > 1) expanded.resize(values.size(), expanded[0]);  // one range in a table
          for (std::size_t k = 0; k < expanded.size(); ++k) expanded[k][name] = values[k % values.size()];
        };
        if (const auto* names = item.as_table())
          for (const auto& [name, value] : *names) add(std::string(name.str()), value);
        else
          add(std::string(key.str()), item);
        cases.insert(cases.end(), expanded.begin(), expanded.end());
      }
      choice.merge(cases.at(picked(seed, id + "/" + std::string(key.str()), cases.size())));
    }
  return choice;
}

/// What an exercise gives, as a statement says it: "$theta_0 > 0$ and $theta_0 < alpha$".
std::string given_in_words(const toml::node& given) {
  std::string words;
  if (const auto* list = given.as_array())
    for (const auto& item : *list)
      if (const auto text = item.value_or(std::string()); !text.empty())
        words += (words.empty() ? "$" : " and $") + text + "$";
  return words;
}

Exercise read_exercise(toml::table table, const std::string& file, const std::string& seed) {
  Exercise exercise;
  exercise.id = table["id"].value_or(std::string("without id"));
  const std::string where = file + ", exercise " + exercise.id;
  try {
    exercise.choice = chosen(table, exercise.id, seed);
    table.erase("vary");
    Choice texts = exercise.choice;
    if (auto* given = table.get("given")) {
      fill_in(*given, texts);
      texts["given"] = given_in_words(*given);
    }
    fill_in(table, texts);
  } catch (const std::runtime_error& error) {
    throw BadInput(where + ": " + error.what());
  }
  if (!exercise.choice.empty()) exercise.seed = seed;
  const auto answers = taken(table, "answer");
  for (const auto& slip : taken(table, "slip")) exercise.slips.push_back(read_slip(slip, where));
  for (const auto& option : taken(table, "option")) {
    TomlRow row(option, where + ", option");
    exercise.options.push_back({row.text("text", true), row.text("claim", true), row.text("note"),
                                row.text("says"), row.text("hint")});
    row.done();
  }
  if (auto& options = exercise.options; !options.empty()) {  // their order is what varies
    const std::size_t first = picked(seed, exercise.id + "/options", options.size());
    std::rotate(options.begin(), options.begin() + static_cast<std::ptrdiff_t>(first), options.end());
    exercise.choice["options"] = std::to_string(first);
    exercise.seed = seed;
  }
  for (auto& assumption : taken(table, "assumption")) {
    const Texts put = texts_taken(assumption, "put");
    TomlRow row(assumption, where + ", assumption");
    exercise.assumptions.push_back({put, row.text("says", true)});
    row.done();
  }
  TomlRow row(table, where);
  for (const char* taken_above : {"answer", "slip", "option", "assumption", "vary"})
    (void)row.text(taken_above);  // named among the keys
  (void)row.text("id", true);
  exercise.lesson = static_cast<int>(row.whole("lesson").value_or(0));
  exercise.title = row.text("title", true);
  exercise.statement = row.text("statement", true);
  exercise.symbols = row.texts("symbols");
  std::erase(exercise.symbols, "");
  exercise.example = row.text("example");
  exercise.name = row.text("name");
  exercise.given = row.texts("given");
  std::erase(exercise.given, "");
  for (const auto& text : exercise.given) reading(text, [&] { return parse_relation(text); });
  exercise.bound = row.text("bound");
  exercise.pivot = row.text("pivot");
  exercise.unit = row.text("unit");
  exercise.digits = static_cast<int>(row.whole("digits").value_or(exercise.digits));
  if (exercise.digits < 1 || exercise.digits > 17) row.fail("'digits' must be from 1 to 17");
  exercise.hints = row.texts("hints");
  exercise.equivalents = row.texts("equivalents");
  constexpr std::array kinds{"expression", "equation", "number", "choice", "wrong_term"};
  const auto kind = std::find(kinds.begin(), kinds.end(), row.text("kind", true));
  row.done();
  if (kind == kinds.end()) row.fail(fmt::format("the kind is none of {}", fmt::join(kinds, ", ")));
  exercise.kind = static_cast<Kind>(kind - kinds.begin());
  if (answers.size() != 1) row.fail("one answer is wanted");
  exercise.answer = read_reference(answers.front(), where);
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
      throw BadInput(fmt::format("{}, line {}: {}", name, error.source().begin.line, error.description()));
    }
    const auto* list = table["exercise"].as_array();
    if (list == nullptr) throw BadInput(name + ": no [[exercise]]");
    for (const auto& item : *list) {
      if (!item.is_table()) throw BadInput(name + ": [[exercise]] must be a table");
      exercises.push_back(read_exercise(*item.as_table(), name, seed));
      if (!ids.insert(exercises.back().id).second)
        throw BadInput(name + ": a second exercise " + exercises.back().id);
    }
  }
  return exercises;
}

std::filesystem::path exercises_folder() { return data_folder() / "exercises"; }

}  // namespace rederive::classroom
