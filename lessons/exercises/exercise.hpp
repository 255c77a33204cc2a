// An exercise: a table in lessons/exercises/*.toml, as README.md explains, read into a struct.
#pragma once

#include <filesystem>
#include <lessons/exercises/course.hpp>
#include <lessons/exercises/variants.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rederive::classroom {

/// A wrong answer that students give to one exercise, and what to say about it.
struct ListedSlip {
  std::string note, says;
  std::optional<Reference> road;  ///< the wrong answer as a computation
  std::string typed;              ///< or as students type it
  std::string hint;               ///< for a student who asks for one after it
  int digits = 0;                 ///< to which a number is recognised; 0: those that the exercise asks for
};

struct Option {
  std::string text;
  std::string claim;  ///< in our syntax, or a verdict of the ledger: it decides which option is right
  std::string note, says, hint;  ///< for a student who chose it wrongly
};

/// An answer that is right under an assumption that was not given.
struct Assumption {
  std::map<std::string, std::string> put;  ///< symbol → expression, which it makes of the answer
  std::string says;
};

/// A law from which a working may begin: a table [[law]] of the file, or of laws.toml beside it.
struct Law {
  std::vector<std::string> names;      ///< "Newton", "Newton's law"
  std::vector<std::string> equations;  ///< "V - m*g = m*y_cddot"
  std::vector<std::string> given;      ///< what the exercise must give for the law to hold: "theta > 0"
};

struct Exercise {
  const Course* course = nullptr;
  std::string id, title, statement;
  std::string example;  ///< of the syntax: an answer to another question
  std::string pivot;    ///< of an equation: a symbol in which it is linear
  std::string unit;     ///< of a number, "1" if it has none
  std::string name;     ///< of the quantity that is asked for, "y_c" or "V/m"; "name =" may precede an answer
  std::string bound;    ///< a relation that may precede it, too: ">=" if the least value is asked for
  int lesson = 0;
  Kind kind = Kind::expression;
  std::vector<std::string> symbols;  ///< that an answer may use
  std::vector<std::string> given;    ///< about symbols; {given} in the texts says it: "theta_0 > 0"
  Reference answer;
  int digits = 3;  ///< significant digits of a number
  std::vector<std::string> hints, equivalents;
  std::vector<ListedSlip> slips;
  std::vector<Option> options;
  std::vector<Assumption> assumptions;
  std::vector<Law> laws;  ///< from which a working may begin
  Choice choice;          ///< what replaces the names in braces; empty if it has no variants
  std::string seed;       ///< of the variant
  std::string place;      ///< "FILE:LINE" of its table; empty for a step of a working

  const paper::Paper& paper() const { return course->paper; }
  const language::Symbols& language() const { return course->paper.symbols; }  ///< in which answers are read
  bool asks_for_formula() const { return kind == Kind::expression || kind == Kind::equation; }
};

/// Reads all exercises of a folder, in the order of its files, or those of one file; with a seed, in the
/// variant of that seed.
/// Throws BadInput with file, line, exercise and what is wrong.
std::vector<Exercise> read_exercises(const Course& course, const std::filesystem::path& folder,
                                     const std::string& seed = "");
/// Returns the folder that ships with the project.
std::filesystem::path exercises_folder();

}  // namespace rederive::classroom
