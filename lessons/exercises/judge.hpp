// Judges one answer: what was read, right or wrong, and what to say about it.
#pragma once

#include <functional>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/sieve.hpp>
#include <lessons/exercises/trees.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rederive::classroom {

/// What comes back. `verdict`: correct, wrong_form, correct_if, wrong, invalid, undecided. `note`: a stable
/// word.
struct Opinion {
  std::string verdict, note, read_as, feedback;
  std::optional<Witness> witness;
  double score = 0;
  int line = 0;  ///< of a working: the line that is meant
};

/// A wrong answer to compare with, computed beforehand.
struct Road {
  std::string note, says, verdict;
  Relation relation = {};
  std::optional<Signature> signature = {};
  double number = 0;
  int digits =
      0;  ///< to which a number is recognised; 0: to those asked for, and those typed if they are more
};

/// An exercise with its answer and its wrong roads computed: made once, used for a whole class.
struct Prepared {
  Exercise exercise;
  Answer answer;
  std::vector<Point> points;
  std::optional<Signature> signature;
  Symbols symbols;                ///< of the paper, with the ranges that the exercise gives
  std::vector<Relation> assumed;  ///< what else it gives: relations of several symbols
  std::optional<Sieve> sieve;     ///< of a formula
  std::vector<Road> roads;        ///< the catalogued slips and assumptions; of a number its other slips, too
  std::size_t choice = 0;         ///< the right option or term, from 1
};

/// Computes the answer. Throws BadInput naming file, line and exercise if its data do not hold together.
Prepared prepare(const Exercise& exercise);
/// Judges an answer as typed.
Opinion judge_answer(const Prepared& prepared, const std::string& text);
/// What judging an answer may take, in seconds of the processor and megabytes beyond what this process has.
/// Right answers take a small part of it, on a machine that is busy with other work too: where the prover
/// gives up, it does so by what it has counted.
constexpr double most_judging_seconds = 20;
constexpr long most_judging_megabytes = 1024;
/// The same for whatever may have been typed: undecided beyond most_judging_seconds or
/// most_judging_megabytes.
Opinion judge_bounded(const Exercise& exercise, const std::string& text);
/// What `judge` says, or that it could not, within the same bounds.
Opinion bounded(const std::function<Opinion()>& judge);
/// A step of a working as an exercise of its own, for expressions or equations: say `before` in another way.
Exercise as_exercise(const Exercise& whole, const Relation& before, const Relation& after);
Prepared prepare_step(const Prepared& whole, const Relation& before, const Relation& after);

/// A working, judged: each line must follow from the one before, and the last one be the answer.
struct Working {
  Opinion opinion;     ///< of the first line that does not follow, else of the answer
  std::string answer;  ///< the last line
  Exercise about;      ///< what the opinion is of: a step, else the exercise
};
/// Judges numbered lines (working.cpp says what a line may be), each step within the bounds of an answer.
Working judge_working(const Exercise& exercise, const std::vector<std::pair<int, std::string>>& lines);
/// The right answer in our syntax, or as a number with its unit, or as a letter.
std::string model_answer(const Prepared& prepared);
/// 0 correct, 1 wrong, 2 invalid, 3 undecided.
int exit_code(const Opinion& opinion);

// By kind; used by judge_answer.
/// Text → the statement to judge: of "y_c = ..." the right side where an expression is asked for and y_c is
/// its name. Throws SyntaxError.
Relation read_answer(const Exercise& exercise, const std::string& text);
/// Whether this is the name of what the exercise asks for, in any order of its factors.
bool is_asked_for(const Exercise& exercise, const Tree& left);
/// Throws SyntaxError unless the relation may stand behind the name: =, and the bound's, strict or not.
void check_relation(const Exercise& exercise, const std::string& relation);
/// "p = 2.69 1/s" without what stands before the value. Throws SyntaxError for "p < 2.69 1/s".
std::string without_name(const Exercise& exercise, const std::string& text);
Opinion judge_formula(const Prepared& prepared, const std::string& text);
Opinion judge_formula(const Prepared& prepared, const Relation& read);
Opinion judge_number(const Prepared& prepared, const std::string& text);
Opinion judge_choice(const Prepared& prepared, const std::string& text);
/// The wrong roads that an exercise names, filled in once the answer is there.
void add_roads(Prepared& prepared);
/// What comes of a number by the slips of a pen in its formula.
void add_roads_of_number(Prepared& prepared);

/// Whether a verdict is that of a right answer.
bool is_right(Verdict verdict);
/// The project's word on two statements of an exercise.
Proof proof_of(const Prepared& prepared, const Relation& read, const Relation& against);
/// What is printed, with functions as students type them: abs, not fabs.
std::string as_typed(const std::string& printed);
/// The opinion with a verdict, a note, a feedback and a score.
Opinion found(Opinion opinion, const std::string& verdict, const std::string& note, const std::string& says,
              double score);
/// What to say of a formula that is wrong; `mine` is its signature.
Opinion why_wrong(const Prepared& prepared, const Relation& read, const std::optional<Signature>& mine,
                  const Opinion& start);
/// A point with a number of one or two digits for each symbol, at which an answer differs from the right one:
/// both values there to six digits, those of the pivot of an equation; of one without pivot the difference of
/// its sides, where the right one holds.
std::optional<Witness> by_hand(const Prepared& prepared, const Relation& read);

/// What slips.toml says of a note: in its table "answer" or "number" what is wrong, in "part" with {} for the
/// part of the answer, in "hint" how to look for it; empty where it says nothing.
std::string slip_words(const std::string& table, const std::string& note);
Opinion invalid(const std::string& note, const std::string& feedback);
/// A text that could not be read, with a caret.
Opinion invalid(const SyntaxError& error, const std::string& text);

}  // namespace rederive::classroom
