// Defines what exercises use: a paper, numeric functions, and right answers computed from both.
#pragma once

#include <filesystem>
#include <functional>
#include <lessons/page/lesson.hpp>
#include <set>

namespace rederive::classroom {

/// The arguments of a numeric function by their names.
using Arguments = std::map<std::string, double>;

/// A number that exercises ask for and that only numerics can compute.
struct NumericFunction {
  struct Argument {
    std::string name;
    double least, largest;
    bool is_needed = true;
  };
  std::string name;
  std::vector<Argument> arguments;
  double (*value)(const Arguments& arguments);
  /// Writes the steps by which the value is computed.
  void (*explain)(const Arguments& arguments, page::Page& page);
};

/// The lessons to which the exercises belong, as web pages.
struct LessonPages {
  /// Returns the titles of the lessons by the names of their pages, in order: "lesson-01-…" without ".html".
  std::function<std::map<std::string, std::string>()> titles;
  /// Returns the page of a lesson with the forms of exercises in a file, which forms_json has written.
  std::function<std::string(const std::string& lesson, const std::filesystem::path& forms)> page;
  /// Returns a lesson in Markdown.
  std::function<std::string(const std::string& lesson)> markdown;
  bool has_workbench = false;
};

struct Course {
  const paper::Paper& paper;
  std::filesystem::path exercises;  ///< a TOML file, or a folder with TOML files
  LessonPages lessons;
  std::string program;             ///< what a user types before a subcommand: "exercises"
  std::filesystem::path progress;  ///< the file in which progress is kept unless another one is named
  /// The values of names wherever they are used: an answer may use the name or the value.
  std::vector<language::Given> definitions = {};
  /// Derivations that exercises name and that the paper does not contain.
  paper::Derivations derivations = {};
  std::vector<NumericFunction> functions = {};
  /// Sizes of symbols, without sign, such as the things have that the paper is about; and relations that hold
  /// for such things. Points at which a student checks an answer by hand have them where they can.
  std::map<std::string, std::vector<std::string>> usual_sizes = {};
  std::vector<std::string> usually = {};
};

/// Returns the function of that name. Throws std::out_of_range, with the name, if there is none.
const NumericFunction& function_named(const std::string& name, const Course& course);
/// Throws std::invalid_argument unless the function has the arguments that it needs, each in its range, and
/// no others.
void check_arguments(const NumericFunction& function, const Arguments& arguments);
/// Adds to `given` the definitions whose names and values use only the symbols in `at_hand`, except the
/// definition of `asked_for`, the name of the answer.
void add_definitions(std::vector<language::Given>& given, const std::set<std::string>& at_hand,
                     const std::string& asked_for, const Course& course);

/// The kind of an exercise: what it asks for.
enum class Kind { expression, equation, number, choice, wrong_term };

/// The source of an answer: a derivation, and a few operations on it. It is never a formula typed into the
/// exercise.
struct Reference {
  enum class Side { left, right, whole };
  std::string derivation;                  ///< an equation of the paper, as derived: "13"
  std::string row;                         ///< a row of the ledger, for its verdict or its wrong term: "17b"
  std::size_t slip = 0;                    ///< the row gets another wrong term, a slip of this number
  std::string function;                    ///< a number from numerics: "amplitude_without_impact"
  Side side = Side::right;                 ///< of the derivation
  std::string solve_for;                   ///< a symbol in which the equation is linear
  std::map<std::string, std::string> put;  ///< symbol → expression, substituted after solving
  std::string differentiate;               ///< by this symbol, after substituting
  Arguments arguments;                     ///< of the function
};

/// The value of a reference: a relation (one side alone for an expression), or a number.
struct Answer {
  language::Relation relation;
  std::vector<language::Given> given;
  double number = 0;
  /// The operations on the derivation, each with its result.
  std::vector<std::pair<std::string, language::Relation>> way;
  /// The values that are substituted into the relation, an expression, to get the number.
  std::vector<std::pair<std::string, language::Tree>> values;
};

/// Returns the derivation that a reference names. Throws std::out_of_range if there is none.
mechanics::Derivation derivation_for(const Reference& reference, const Course& course);
/// Computes the answer to an exercise of that kind. Throws std::runtime_error if the reference gives none.
Answer resolve(const Reference& reference, Kind kind, const Course& course);

}  // namespace rederive::classroom
