// An exercise as it stands in lessons/exercises/*.toml, and the answer that it refers to.
#pragma once

#include <derivations/language/tree.hpp>
#include <derivations/mechanics/derivation.hpp>
#include <filesystem>
#include <lessons/exercises/course.hpp>
#include <lessons/exercises/variants.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rederive::classroom {

enum class Kind { expression, equation, number, choice, wrong_term };

/// Where an answer comes from: a derivation, worked on a little. Never a formula typed into the exercise.
struct Reference {
  std::string derivation;                  ///< an equation of the paper, as derived: "13"
  std::string row;                         ///< a row of the ledger, for its verdict or its wrong term: "17b"
  std::size_t slip = 0;                    ///< the row has another wrong term: a slip of this number
  std::string function;                    ///< a number from the numerics: "amplitude_without_impact"
  std::string side = "right";              ///< of the derivation: left, right, whole
  std::string solve_for;                   ///< a symbol that the equation is linear in
  std::map<std::string, std::string> put;  ///< symbol → expression, put in after solving
  std::string differentiate;               ///< by this symbol, after putting in
  Arguments arguments;                     ///< of the function
};

/// A wrong road that students take, and what to say to one who took it.
struct Slip {
  std::string note, says;
  std::optional<Reference> road;  ///< the wrong answer, computed
  std::string typed;              ///< or the wrong answer as students write it
  std::string hint;               ///< for one who asks for a hint after it
  int digits = 0;                 ///< of a number: to how many it is recognised; 0: to those asked for
};

struct Option {
  std::string text, claim;       ///< claim: in our syntax, or a verdict of the ledger; decides what is right
  std::string note, says, hint;  ///< said to one who chose it wrongly
};

/// Right under an assumption that was not given.
struct Assumption {
  std::map<std::string, std::string> put;
  std::string says;
};

struct Exercise {
  const Course* course = nullptr;  ///< that it belongs to
  std::string id, title, statement, example, pivot, unit;
  std::string name;  ///< of what is asked for, a symbol or such as "V/m"; an answer may stand behind it and =
  std::string bound;  ///< or behind it and this relation: ">=" where the least value is asked for
  int lesson = 0;
  Kind kind = Kind::expression;
  std::vector<std::string> symbols;  ///< that an answer may use
  std::vector<std::string> given;    ///< of symbols, as {given} in the texts says it: "theta_0 > 0"
  Reference answer;
  int digits = 3;  ///< of a number, the significant ones
  std::vector<std::string> hints, equivalents;
  std::vector<Slip> slips;
  std::vector<Option> options;
  std::vector<Assumption> assumptions;
  Choice choice;      ///< what was put into the braces of its texts; empty where it has no variants
  std::string seed;   ///< by which
  std::string place;  ///< "FILE:LINE" of its table; empty of a step of a working

  const Paper& paper() const { return course->paper; }
  const Symbols& language() const { return course->paper.symbols; }  ///< in which answers are read
};

/// All exercises, in the order of lessons; with a seed, those that have variants in the one of that seed.
/// Throws BadInput naming file, line, exercise and what is wrong.
std::vector<Exercise> read_exercises(const Course& course, const std::filesystem::path& folder,
                                     const std::string& seed = "");
/// The folder that ships with the project.
std::filesystem::path exercises_folder();

/// The derivation that a reference names.
Derivation argument_of(const Reference& reference, const Course& course);

/// What a reference comes to: a relation (one side alone for an expression), or a number.
struct Answer {
  Relation relation;
  std::vector<Given> given;
  double number = 0;
  std::vector<std::pair<std::string, Relation>>
      way;  ///< from the derivation on: what was done, what came of it
  std::vector<std::pair<std::string, Tree>>
      values;  ///< put into the relation, an expression, to have the number
};
/// Computes it.
Answer resolve(const Reference& reference, Kind kind, const Course& course);

/// The terms that a reader can point at in a printed relation, from left to right.
std::vector<Tree> terms_to_point_at(const Relation& relation);
/// A row as printed, with one wrong term: as the paper has it, or corrected and with a slip of `mutants` in
/// it.
Relation printed_with_slip(const Reference& reference, const Paper& paper);
/// The one term (from 1) that, edited alone, makes what is printed say what is derived for the row. Throws if
/// there is not exactly one.
std::size_t wrong_term(const Relation& printed, const std::string& row, const Paper& paper);

}  // namespace rederive::classroom
