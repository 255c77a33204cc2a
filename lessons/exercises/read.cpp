// lessons/exercises/*.toml → exercises; what is missing, misspelt or of no use is refused with file and line.
#include <algorithm>
#include <array>
#include <charconv>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/toml_table.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/trees.hpp>
#include <lessons/exercises/units.hpp>

namespace rederive::classroom {
namespace {

using Texts = std::map<std::string, std::string>;
using Words = std::vector<std::string>;

const Words kind_names{"expression", "equation", "number", "choice", "wrong_term"};  // in the order of Kind

template <class Table>
Words names_in(const Table& table) {
  Words names;
  for (const auto& [name, value] : table) names.push_back(name);
  return names;
}

/// Runs a check of a text; what it throws is a complaint about the key.
template <class Check>
void check_text(const TomlTable& table, const std::string& key, const std::string& text, const Check& check) {
  if (text.empty()) return;
  try {
    check(text);
  } catch (const std::exception& error) {  // of the language, or of GiNaC
    table.fail(fmt::format("'{}' in '{}': {}", text, key, error.what()), key);
  }
}

void check_expression(const TomlTable& table, const std::string& key, const std::string& text,
                      const Symbols& symbols) {
  check_text(table, key, text,
             [&](const std::string& formula) { (void)lower(parse(formula, symbols), symbols); });
}

void check_symbol(const TomlTable& table, const std::string& key, const std::string& name,
                  const Symbols& symbols) {
  if (!name.empty()) table.check_word(key, name, symbols.names());
}

/// Symbols and what is put in their place.
Texts read_put(TomlTable& table, const Symbols& symbols) {
  Texts put = table.named_texts("put");
  for (const auto& [name, text] : put) {
    check_symbol(table, "put", name, symbols);
    check_expression(table, "put", text, symbols);
    if (text.empty()) table.fail("'" + name + "' in 'put' is empty", "put");
  }
  return put;
}

/// A number that is written as a text, since it may vary.
template <class Number>
Number number_in(const TomlTable& table, const std::string& key, const std::string& text) {
  Number value{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || !std::isfinite(static_cast<double>(value)))
    table.fail(fmt::format("'{}' in '{}' must be a number", text, key), key);
  return value;
}

void read_arguments(TomlTable& table, Reference& reference, const Course& course) {
  Words names;
  for (const NumericFunction& function : course.functions)
    for (const auto& argument : function.arguments)
      if (std::ranges::count(names, argument.name) == 0) names.push_back(argument.name);
  for (const auto& [name, text] : table.named_texts("arguments")) {
    table.check_word("arguments", name, names);
    reference.arguments[name] = number_in<double>(table, "arguments", text);
  }
  if (reference.function.empty()) return;
  try {
    check_arguments(function_named(reference.function, course), reference.arguments);
  } catch (const std::invalid_argument& error) {
    table.fail(error.what(), "function");
  }
}

Reference read_reference(TomlTable& table, const Course& course) {
  const Symbols& symbols = course.paper.symbols;
  Words functions;
  for (const NumericFunction& function : course.functions) functions.push_back(function.name);
  Reference result;
  result.derivation = table.text("derivation");
  result.row = table.text("row");
  const std::string slip = table.text("slip");
  if (!slip.empty()) result.slip = number_in<std::size_t>(table, "slip", slip);
  result.function = table.word("function", functions);
  if (table.has("side")) result.side = table.word("side", {"left", "right", "whole"});
  result.solve_for = table.text("solve_for");
  result.differentiate = table.text("differentiate");
  result.put = read_put(table, symbols);
  read_arguments(table, result, course);
  table.done();
  for (const char* key : {"derivation", "row"}) {
    Words ids = course.paper.derivations.ids();
    if (*key == 'd') std::ranges::copy(course.derivations.ids(), std::back_inserter(ids));
    const std::string& id = *key == 'd' ? result.derivation : result.row;
    if (!id.empty()) table.check_word(key, id, ids);
  }
  check_symbol(table, "solve_for", result.solve_for, symbols);
  check_symbol(table, "differentiate", result.differentiate, symbols);
  const int given = !result.derivation.empty() + !result.row.empty() + !result.function.empty();
  if (given != 1) table.fail("exactly one of 'derivation', 'row' and 'function' is needed");
  return result;
}

Slip read_slip(TomlTable& table, const Course& course) {
  Slip slip;
  slip.note = table.needed_line("note");
  slip.says = table.needed_text("says");
  slip.typed = table.text("typed");
  slip.hint = table.needed_text("hint");
  slip.digits = static_cast<int>(table.whole("digits", 1, 17).value_or(0));
  std::optional<TomlTable> road = table.table("road");
  table.done();
  if (road.has_value() != slip.typed.empty()) table.fail("exactly one of 'road' and 'typed' is needed");
  if (road) slip.road = read_reference(*road, course);
  return slip;
}

Option read_option(TomlTable& table, bool is_of_ledger, const Symbols& symbols) {
  Option option;
  option.text = table.needed_text("text");
  option.claim = table.needed_text("claim");
  option.note = table.line("note");
  option.says = table.text("says");
  option.hint = table.text("hint");
  table.done();
  if (is_of_ledger)
    table.check_word("claim", option.claim,
                     {"proved", "proved_under", "approximation", "refuted", "undecided"});
  else
    check_text(table, "claim", option.claim,
               [&](const std::string& text) { (void)parse_statement(text, symbols); });
  return option;
}

Assumption read_assumption(TomlTable& table, const Symbols& symbols) {
  Assumption assumption{read_put(table, symbols), table.needed_text("says")};
  table.done();
  return assumption;
}

/// All that can be chosen for one list of `vary`: texts, or names that go together; a range gives its values.
std::vector<Choice> cases_of(TomlTable& vary, const std::string& key) {
  std::vector<Choice> cases;
  for (const Texts& item : vary.alternatives(key)) {
    std::vector<Choice> expanded(1);
    for (const auto& [name, text] : item) {
      if (text.find_first_of("{}") != std::string::npos)
        throw std::runtime_error("'" + text + "' must be a text without braces");
      const Words values = values_of(text);
      if (values.size() > 1 && expanded.size() > 1)
        throw std::runtime_error("only one name of a table can have a range");
      if (values.size() > 1) expanded.resize(values.size(), expanded[0]);
      for (std::size_t k = 0; k < expanded.size(); ++k) expanded[k][name] = values[k % values.size()];
    }
    cases.insert(cases.end(), expanded.begin(), expanded.end());
  }
  if (cases.empty()) throw std::runtime_error("the list is empty");
  for (const Choice& one : cases)
    if (names_in(one) != names_in(cases.front()))
      throw std::runtime_error(
          fmt::format("all tables of a list must have the same names; one has {}, one {}",
                      fmt::join(names_in(cases.front()), ", "), fmt::join(names_in(one), ", ")));
  return cases;
}

/// By the seed, one entry of each list of `vary`.
Choice chosen(TomlTable& exercise, const std::string& id, const std::string& seed) {
  Choice choice;
  std::optional<TomlTable> vary = exercise.table("vary");
  if (!vary) return choice;
  for (const std::string& key : vary->keys()) try {
      const std::vector<Choice> cases = cases_of(*vary, key);
      for (const auto& [name, text] : cases[picked(seed, id + "/" + key, cases.size())])
        if (!choice.emplace(name, text).second)
          throw std::runtime_error("another list also has the name '" + name + "'");
    } catch (const BadInput&) {
      throw;
    } catch (const std::runtime_error& error) {
      vary->fail(fmt::format("'{}' in 'vary': {}", key, error.what()), key);
    }
  return choice;
}

/// By the seed, which option is the first one.
void turn_options(Exercise& exercise, const std::string& seed) {
  auto& options = exercise.options;
  if (options.empty()) return;
  const std::size_t first = picked(seed, exercise.id + "/options", options.size());
  std::rotate(options.begin(), options.begin() + static_cast<std::ptrdiff_t>(first), options.end());
  exercise.choice["options"] = std::to_string(first);
  exercise.seed = seed;
}

/// What the statement gives of symbols.
std::vector<std::string> read_given(TomlTable& table, const Symbols& symbols) {
  std::vector<std::string> given = table.texts("given");
  std::erase(given, "");
  for (const std::string& text : given)
    check_text(table, "given", text,
               [&](const std::string& relation) { (void)parse_relation(relation, symbols); });
  return given;
}

/// The same as a statement says it: "$theta_0 > 0$ and $theta_0 < alpha$".
std::string given_in_words(const std::vector<std::string>& given) {
  std::string words;
  for (const std::string& text : given) words += (words.empty() ? "$" : " and $") + text + "$";
  return words;
}

/// What an exercise of this kind must have, and must not.
void check_kind(const TomlTable& table, const Exercise& exercise) {
  const Reference& answer = exercise.answer;
  const Kind kind = exercise.kind;
  const bool is_row = !answer.row.empty();
  constexpr std::size_t letters = 26;
  if ((kind == Kind::wrong_term && !is_row) || (is_row && kind != Kind::wrong_term && kind != Kind::choice))
    table.fail("'row' belongs to exercises of the kinds 'wrong_term', which need it, and 'choice'", "answer");
  if (!answer.function.empty() && kind != Kind::number)
    table.fail("'function' belongs to exercises of the kind 'number'", "answer");
  if ((kind == Kind::choice) == exercise.options.empty())
    table.fail("options belong to exercises of the kind 'choice', which need them", "option");
  if (exercise.options.size() > letters)
    table.fail(fmt::format("there can be at most {} options", letters), "option");
  if (kind == Kind::equation && answer.side != "whole")
    table.fail("the answer of an equation needs side = \"whole\"", "answer");
  if ((kind == Kind::expression || kind == Kind::number) && answer.side == "whole")
    table.fail("side = \"whole\" is an equation, not an expression or a number", "answer");
  if (!exercise.bound.empty() && exercise.name.empty()) table.fail("'bound' needs a 'name'", "bound");
}

/// What an exercise says by itself: its texts, numbers and symbols.
void read_texts(TomlTable& table, Exercise& exercise) {
  exercise.lesson = static_cast<int>(table.whole("lesson", 0, 99).value_or(0));
  exercise.title = table.needed_text("title");
  const auto kind = std::ranges::find(kind_names, table.needed_word("kind", kind_names));
  exercise.kind = static_cast<Kind>(kind - kind_names.begin());
  exercise.statement = table.needed_text("statement");
  exercise.symbols = table.texts("symbols");
  std::erase(exercise.symbols, "");
  exercise.example = table.text("example");
  exercise.name = table.text("name");
  exercise.bound = table.word("bound", {"<", "<=", ">", ">="});
  exercise.pivot = table.text("pivot");
  exercise.unit = table.text("unit");
  exercise.digits = static_cast<int>(table.whole("digits", 1, 17).value_or(exercise.digits));
  exercise.hints = table.texts("hints");
  exercise.equivalents = table.texts("equivalents");
}

void check_texts(const TomlTable& table, const Exercise& exercise) {
  for (const std::string& name : exercise.symbols) check_symbol(table, "symbols", name, exercise.language());
  check_symbol(table, "pivot", exercise.pivot, exercise.language());
  check_expression(table, "name", exercise.name, exercise.language());
  if (!exercise.unit.empty() && exercise.unit != "1" && !is_unit(exercise.unit))
    table.fail("'" + exercise.unit + "' must be a unit such as \"m/s^2\", or \"1\"", "unit");
}

Exercise read_exercise(TomlTable& table, const std::string& seed, const Course& course) {
  const Symbols& symbols = course.paper.symbols;
  Exercise exercise;
  exercise.course = &course;
  exercise.place = table.where();
  exercise.id = table.needed_line("id");
  if (!exercise.id.empty()) table.call_it("exercise " + exercise.id);
  if (exercise.id.find('/') != std::string::npos)
    table.fail("an id must not contain '/', because it names a file", "id");
  exercise.choice = chosen(table, exercise.id, seed);
  if (!exercise.choice.empty()) exercise.seed = seed;
  const auto fill_in = [&](const Choice& texts) {
    table.fill_in([texts, &symbols](const std::string& text) { return filled(text, texts, symbols); });
  };
  fill_in(exercise.choice);
  exercise.given = read_given(table, symbols);
  Choice texts = exercise.choice;
  if (table.has("given")) texts["given"] = given_in_words(exercise.given);
  fill_in(texts);
  read_texts(table, exercise);
  std::optional<TomlTable> answer = table.table("answer");
  std::vector<TomlTable> slips = table.tables("slip"), options = table.tables("option"),
                         assumptions = table.tables("assumption");
  table.done();
  check_texts(table, exercise);
  if (!answer) table.fail("'answer' is missing");
  exercise.answer = read_reference(*answer, course);
  for (TomlTable& slip : slips) exercise.slips.push_back(read_slip(slip, course));
  for (TomlTable& assumption : assumptions)
    exercise.assumptions.push_back(read_assumption(assumption, symbols));
  for (TomlTable& option : options)
    exercise.options.push_back(read_option(option, !exercise.answer.row.empty(), symbols));
  check_kind(table, exercise);
  turn_options(exercise, seed);
  return exercise;
}

/// The files of exercises, in the order of their names.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error))
    if (file->path().extension() == ".toml" && file->path().filename() != "slips.toml")
      files.push_back(file->path());
  if (error) throw BadInput("cannot read the folder '" + folder.string() + "': " + error.message());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

std::vector<Exercise> read_exercises(const Course& course, const std::filesystem::path& folder,
                                     const std::string& seed) {
  std::vector<Exercise> exercises;
  std::map<std::string, std::string> places;
  for (const auto& file : files_in(folder))
    for (TomlTable& table : tables_of(file, "exercise")) {
      exercises.push_back(read_exercise(table, seed, course));
      const Exercise& last = exercises.back();
      if (const auto [place, is_new] = places.emplace(last.id, last.place); !is_new)
        table.fail("a second exercise has this id; the first is at " + place->second, "id");
    }
  return exercises;
}

std::filesystem::path exercises_folder() { return data_folder() / "exercises"; }

}  // namespace rederive::classroom
