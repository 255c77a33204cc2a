// An exercise made ready for judging: its answer and the wrong answers to compare with, computed once and
// used for a whole class.
#pragma once

#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/opinion.hpp>
#include <lessons/exercises/trees.hpp>
#include <optional>
#include <vector>

namespace rederive::classroom {

/// A wrong answer to compare with: a formula, or a number.
struct Road {
  Opinion opinion;  ///< on an answer that is the same
  language::Relation relation = {};
  std::optional<Signature> signature = {};
  double number = 0;
  /// The number of digits to which a number is recognised. 0: the digits asked for, or the digits typed if
  /// they are more.
  int digits = 0;
};

struct Prepared {
  Exercise exercise;
  Answer answer;
  std::vector<numbers::Point> points;
  std::optional<Signature> signature;
  language::Symbols symbols;                ///< of the paper, with the ranges that the exercise gives
  std::vector<language::Relation> assumed;  ///< what else it gives: relations between symbols
  std::optional<paper::Sieve> sieve;        ///< of a formula
  std::vector<Road> roads;                  ///< listed slips, then assumptions, then other slips in a number
  std::size_t choice = 0;                   ///< the right option or term, from 1
};

/// Computes the answer. Throws BadInput, with file, line and exercise, if its data do not fit together.
Prepared prepare(const Exercise& exercise);
/// Returns a step of a working as an exercise of its own: to say `before` in another way, as `after` does.
Prepared prepare_step(const Prepared& whole, const language::Relation& before,
                      const language::Relation& after);
/// Returns only the exercise of that step.
Exercise step_of(const Exercise& whole, const language::Relation& before, const language::Relation& after);

/// Returns the right answer in our syntax, as a number with its unit, or as a letter.
std::string model_answer(const Prepared& prepared);
/// Returns the values by which a statement is compared with others.
std::optional<Signature> signature_of(const Prepared& prepared, const language::Relation& statement);
/// Decides whether two statements of an exercise say the same.
decide::Proof proof_of(const Prepared& prepared, const language::Relation& read,
                       const language::Relation& against);
/// Returns whether a verdict means a right answer.
bool is_right(decide::Verdict verdict);
/// Returns by how much a value may differ from `right`: half a unit of the last of so many digits.
double allowance(double right, int digits);
/// Returns what a slip in a number looks like. It never says that the slip was made, because other mistakes
/// may lead to the same value.
Opinion wrong_number(const Note& note);

}  // namespace rederive::classroom
