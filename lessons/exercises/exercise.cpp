#include <algorithm>
#include <array>
#include <charconv>
#include <derivations/decide/proof.hpp>
#include <derivations/program/data_folder.hpp>
#include <derivations/program/toml_table.hpp>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/units.hpp>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace program;
namespace {

using Words = std::vector<std::string>;

constexpr auto laws_name = "laws.toml";
const Words kind_names{"expression", "equation", "number", "choice", "wrong_term"};  // in the order of Kind
const Words side_names{"left", "right", "whole"};  // in the order of Reference::Side

/// Reads the tables of one exercise, about the symbols of a course.
class Reader {
 public:
  explicit Reader(const Course& course) : course_(course), symbols_(course.paper.symbols) {}

  Exercise exercise(TomlTable& table, const std::string& seed) const {
    Exercise exercise;
    exercise.course = &course_;
    exercise.place = table.where();
    exercise.id = table.needed_line("id");
    if (!exercise.id.empty()) table.call_it("exercise " + exercise.id);
    if (exercise.id.find('/') != std::string::npos)
      table.fail("an id must not contain '/', because it names a file", "id");
    exercise.choice = chosen(table, exercise.id, seed);
    if (!exercise.choice.empty()) exercise.seed = seed;
    Choice texts = exercise.choice;
    fill_in(table, texts);
    exercise.given = table.texts("given");
    std::erase(exercise.given, "");
    for (const std::string& text : exercise.given)
      check_text(table, "given", text, [](const std::string& given, const Symbols& symbols) {
        return parse_relation(given, symbols);
      });
    if (table.has("given")) texts["given"] = joined_with_and(exercise.given);
    fill_in(table, texts);
    read_texts(table, exercise);
    read_tables(table, exercise);
    check_kind(table, exercise);
    turn_options(exercise, seed);
    return exercise;
  }

  /// Reads the laws of a file.
  std::vector<Law> laws(TomlTable& document) const {
    std::vector<Law> all;
    for (TomlTable& table : document.tables("law")) {
      all.push_back({table.lines("names"), table.texts("equations"), table.texts("given")});
      table.done();
      if (all.back().names.empty() || all.back().equations.empty())
        table.fail("a law needs 'names' and 'equations'");
      for (const std::string& text : all.back().equations)
        check_text(table, "equations", text, [](const std::string& equation, const Symbols& symbols) {
          return parse_relation(equation, symbols);
        });
    }
    return all;
  }

 private:
  void fill_in(TomlTable& table, const Choice& texts) const {
    table.fill_in([texts, this](const std::string& text) { return filled(text, texts, symbols_); });
  }

  /// Returns what is given as a statement says it: "$theta_0 > 0$ and $theta_0 < alpha$".
  static std::string joined_with_and(const Words& given) {
    std::string words;
    for (const std::string& text : given) words += (words.empty() ? "$" : " and $") + text + "$";
    return words;
  }

  /// Reads a text by `parse_it`, whose error becomes one of the key.
  template <class Parse>
  void check_text(const TomlTable& table, const std::string& key, const std::string& text,
                  const Parse& parse_it) const {
    if (text.empty()) return;
    try {
      (void)parse_it(text, symbols_);
    } catch (const std::exception& error) {  // of the language, or of GiNaC
      table.fail(fmt::format("'{}' in '{}': {}", text, key, error.what()), key);
    }
  }
  void check_expression(const TomlTable& table, const std::string& key, const std::string& text) const {
    check_text(table, key, text, [](const std::string& formula, const Symbols& symbols) {
      return lower(parse(formula, symbols), symbols);
    });
  }
  void check_symbol(const TomlTable& table, const std::string& key, const std::string& name) const {
    if (!name.empty()) table.check_word(key, name, symbols_.names());
  }

  /// Reads symbols and what is substituted for them.
  std::map<std::string, std::string> read_put(TomlTable& table) const {
    auto put = table.named_texts("put");
    for (const auto& [name, text] : put) {
      check_symbol(table, "put", name);
      check_expression(table, "put", text);
      if (text.empty()) table.fail("'" + name + "' in 'put' is empty", "put");
    }
    return put;
  }

  /// Reads a number that is written as a text, because it may vary.
  template <class Number>
  static Number number_in(const TomlTable& table, const std::string& key, const std::string& text) {
    Number value{};
    const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || rest != text.data() + text.size() ||
        !std::isfinite(static_cast<double>(value)))
      table.fail(fmt::format("'{}' in '{}' must be a number", text, key), key);
    return value;
  }

  void read_function(TomlTable& table, Reference& reference) const {
    Words functions, arguments;
    for (const NumericFunction& function : course_.functions) {
      functions.push_back(function.name);
      for (const auto& argument : function.arguments)
        if (std::ranges::count(arguments, argument.name) == 0) arguments.push_back(argument.name);
    }
    reference.function = table.word("function", functions);
    for (const auto& [name, text] : table.named_texts("arguments")) {
      table.check_word("arguments", name, arguments);
      reference.arguments[name] = number_in<double>(table, "arguments", text);
    }
    if (reference.function.empty()) return;
    try {
      check_arguments(function_named(reference.function, course_), reference.arguments);
    } catch (const std::invalid_argument& error) {
      table.fail(error.what(), "function");
    }
  }

  Reference read_reference(TomlTable& table) const {
    Reference result;
    result.derivation = table.text("derivation");
    result.row = table.text("row");
    if (const std::string slip = table.text("slip"); !slip.empty())
      result.slip = number_in<std::size_t>(table, "slip", slip);
    if (table.has("side")) result.side = table.needed_one_of<Reference::Side>("side", side_names);
    result.solve_for = table.text("solve_for");
    result.differentiate = table.text("differentiate");
    result.put = read_put(table);
    read_function(table, result);
    table.done();
    Words ids = course_.paper.derivations.ids();
    if (!result.row.empty()) table.check_word("row", result.row, ids);
    std::ranges::copy(course_.derivations.ids(), std::back_inserter(ids));
    if (!result.derivation.empty()) table.check_word("derivation", result.derivation, ids);
    check_symbol(table, "solve_for", result.solve_for);
    check_symbol(table, "differentiate", result.differentiate);
    const int given = !result.derivation.empty() + !result.row.empty() + !result.function.empty();
    if (given != 1) table.fail("exactly one of 'derivation', 'row' and 'function' is needed");
    return result;
  }

  ListedSlip read_slip(TomlTable& table) const {
    ListedSlip slip;
    slip.note = table.needed_line("note");
    slip.says = table.needed_text("says");
    slip.typed = table.text("typed");
    slip.hint = table.needed_text("hint");
    slip.digits = static_cast<int>(table.whole("digits", 1, 17).value_or(0));
    std::optional<TomlTable> road = table.table("road");
    table.done();
    if (road.has_value() != slip.typed.empty()) table.fail("exactly one of 'road' and 'typed' is needed");
    if (road) slip.road = read_reference(*road);
    return slip;
  }

  Option read_option(TomlTable& table, bool is_about_ledger) const {
    Option option;
    option.text = table.needed_text("text");
    option.claim = table.needed_text("claim");
    option.note = table.line("note");
    option.says = table.text("says");
    option.hint = table.text("hint");
    table.done();
    if (is_about_ledger)
      table.check_word("claim", option.claim,
                       {"proved", "proved_under", "approximation", "refuted", "undecided"});
    else
      check_text(table, "claim", option.claim, [](const std::string& claim, const Symbols& symbols) {
        return parse_statement(claim, symbols);
      });
    return option;
  }

  /// Reads what an exercise says by itself: its texts, numbers and symbols.
  void read_texts(TomlTable& table, Exercise& exercise) const {
    exercise.lesson = static_cast<int>(table.whole("lesson", 0, 99).value_or(0));
    exercise.title = table.needed_text("title");
    exercise.kind = table.needed_one_of<Kind>("kind", kind_names);
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

  /// Reads the tables inside that of the exercise, once its texts are known to be right.
  void read_tables(TomlTable& table, Exercise& exercise) const {
    std::optional<TomlTable> answer = table.table("answer");
    std::vector<TomlTable> slips = table.tables("slip"), options = table.tables("option"),
                           assumptions = table.tables("assumption");
    table.done();
    for (const std::string& name : exercise.symbols) check_symbol(table, "symbols", name);
    check_symbol(table, "pivot", exercise.pivot);
    check_expression(table, "name", exercise.name);
    if (!exercise.unit.empty() && exercise.unit != "1" && !is_unit(exercise.unit))
      table.fail("'" + exercise.unit + "' must be a unit such as \"m/s^2\", or \"1\"", "unit");
    if (!answer) table.fail("'answer' is missing");
    exercise.answer = read_reference(*answer);
    for (TomlTable& slip : slips) exercise.slips.push_back(read_slip(slip));
    for (TomlTable& assumption : assumptions) {
      exercise.assumptions.push_back({read_put(assumption), assumption.needed_text("says")});
      assumption.done();
    }
    for (TomlTable& option : options)
      exercise.options.push_back(read_option(option, !exercise.answer.row.empty()));
  }

  /// Refuses what an exercise of its kind must have and has not, or has and must not.
  static void check_kind(const TomlTable& table, const Exercise& exercise) {
    const Reference& answer = exercise.answer;
    const Kind kind = exercise.kind;
    const bool is_row = !answer.row.empty(), is_whole = answer.side == Reference::Side::whole;
    constexpr std::size_t letters = 26;
    struct {
      bool is_wrong;
      std::string says;
      const char* key;
    } const rules[]{
        {(kind == Kind::wrong_term && !is_row) ||
             (is_row && kind != Kind::wrong_term && kind != Kind::choice),
         "'row' belongs to exercises of the kinds 'wrong_term', which need it, and 'choice'", "answer"},
        {!answer.function.empty() && kind != Kind::number,
         "'function' belongs to exercises of the kind 'number'", "answer"},
        {(kind == Kind::choice) == exercise.options.empty(),
         "options belong to exercises of the kind 'choice', which need them", "option"},
        {exercise.options.size() > letters, fmt::format("there can be at most {} options", letters),
         "option"},
        {kind == Kind::equation && !is_whole, "the answer of an equation needs side = \"whole\"", "answer"},
        {(kind == Kind::expression || kind == Kind::number) && is_whole,
         "side = \"whole\" is an equation, not an expression or a number", "answer"},
        {!exercise.bound.empty() && exercise.name.empty(), "'bound' needs a 'name'", "bound"}};
    for (const auto& rule : rules)
      if (rule.is_wrong) table.fail(rule.says, rule.key);
  }

  /// Chooses by the seed which option is the first one.
  static void turn_options(Exercise& exercise, const std::string& seed) {
    auto& options = exercise.options;
    if (options.empty()) return;
    const std::size_t first = picked(seed, exercise.id + "/options", options.size());
    std::rotate(options.begin(), options.begin() + static_cast<std::ptrdiff_t>(first), options.end());
    exercise.choice["options"] = std::to_string(first);
    exercise.seed = seed;
  }

  const Course& course_;
  const Symbols& symbols_;
};

/// Returns the files of exercises in a folder, in the order of their names; or the one file that is given.
std::vector<std::filesystem::path> files_in(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) return {folder};
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator file(folder, error), end; !error && file != end;
       file.increment(error))
    if (file->path().extension() == ".toml" && file->path().filename() != "slips.toml" &&
        file->path().filename() != laws_name)
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
  const Reader reader(course);
  std::vector<Law> shared;
  if (const auto file = folder / laws_name; std::filesystem::exists(file)) {
    TomlTable document(file);
    shared = reader.laws(document);
    document.done();
  }
  for (const auto& file : files_in(folder)) {
    TomlTable document(file);
    std::vector<TomlTable> tables = document.tables("exercise");
    const std::vector<Law> laws = reader.laws(document);
    document.done();
    if (tables.empty()) document.fail("there is no [[exercise]] in this file");
    for (TomlTable& table : tables) {
      exercises.push_back(reader.exercise(table, seed));
      Exercise& last = exercises.back();
      for (const auto& all : {laws, shared})
        std::ranges::copy_if(all, std::back_inserter(last.laws), [&](const Law& law) {
          return std::ranges::all_of(law.given, [&](const std::string& condition) {
            return std::ranges::count(last.given, condition) > 0;
          });
        });
      if (const auto [place, is_new] = places.emplace(last.id, last.place); !is_new)
        table.fail("a second exercise has this id; the first is at " + place->second, "id");
    }
  }
  return exercises;
}

std::filesystem::path exercises_folder() { return data_folder() / "exercises"; }

}  // namespace rederive::classroom
