// Judges one answer: what was read, right or wrong, and what to say about it.
#pragma once

#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/trees.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::classroom {

/// What comes back. `verdict`: correct, wrong_form, correct_if, wrong, invalid, undecided. `note`: a stable
/// word.
struct Opinion {
  std::string verdict, note, read_as, feedback;
  std::optional<Witness> witness;
  double score = 0;
};

/// A wrong answer to compare with, computed beforehand.
struct Road {
  std::string note, says, verdict;
  Relation relation;
  std::optional<Signature> signature;
  double number = 0;
};

/// An exercise with its answer and its wrong roads computed: made once, used for a whole class.
struct Prepared {
  Exercise exercise;
  Answer answer;
  std::vector<Point> points;
  std::optional<Signature> signature;
  std::vector<Road> roads;  ///< the catalogued slips and assumptions first, then the slips of a pen
  std::size_t choice = 0;   ///< the right option or term, from 1
};

/// Computes the answer. Throws std::runtime_error naming the exercise if its data do not hold together.
Prepared prepare(const Exercise& exercise);
/// Judges an answer as typed.
Opinion judge_answer(const Prepared& prepared, const std::string& text);
/// The same for whatever may have been typed: undecided after 1.5 seconds, or beyond 480 MB.
Opinion judge_bounded(const Exercise& exercise, const std::string& text);
/// The right answer in our syntax, or as a number with its unit, or as a letter.
std::string model_answer(const Prepared& prepared);
/// 0 correct, 1 wrong, 2 invalid, 3 undecided.
int exit_code(const Opinion& opinion);

// By kind; used by judge_answer.
Opinion judge_formula(const Prepared& prepared, const std::string& text);
Opinion judge_number(const Prepared& prepared, const std::string& text);
Opinion judge_choice(const Prepared& prepared, const std::string& text);
/// The catalogue of wrong roads of a formula, filled in once the answer is there.
void add_roads(Prepared& prepared);

/// What a note means, for those notes that every exercise shares.
std::string explanation_of(const std::string& note);
Opinion invalid(const std::string& note, const std::string& feedback);
/// A text that could not be read, with a caret.
Opinion invalid(const SyntaxError& error, const std::string& text);
/// Whether the answer has the form that was asked for; what to say if not.
std::optional<std::string> not_in_form(const Exercise& exercise, const Relation& read);

}  // namespace rederive::classroom
