// What the judge says of an answer, as a value.
#pragma once

#include <derivations/decide/decide.hpp>
#include <functional>
#include <lessons/exercises/slips.hpp>
#include <lessons/exercises/student_files.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::classroom {

enum class Outcome { correct, correct_if, wrong, invalid, undecided, ambiguous };
/// Returns the word in JSON and CSV: "correct_if".
std::string to_string(Outcome outcome);
/// Returns a sentence for a student.
std::string in_words(Outcome outcome);

struct Opinion {
  Outcome outcome = Outcome::undecided;
  Note note = {};
  std::string feedback =
      {};                 ///< sentences with marks; "" if the answer is right and nothing else is to be said
  double score = 0;       ///< from 0 to 1
  std::string hint = {};  ///< for a student who asks for one after this answer; "" if there is none for it
  std::string read_as = {};
  bool shows_place = false;  ///< the feedback is lines with a caret below the place, not a sentence
  std::optional<decide::Witness> witness = {};
  int line = 0;                            ///< of a working: the line that is meant
  std::vector<std::string> readings = {};  ///< of an ambiguous answer, each in our own syntax
};

/// Return the opinion on a right answer; on a wrong one, with the words of slips.toml as `feedback` unless it
/// is given, and their hint; on one that is right under a condition, with half the score; on a text that
/// cannot be read, with a caret; on a file that is not judged; and on an answer that cannot be decided.
Opinion right_answer(const std::string& feedback = "");
Opinion wrong_answer(const Note& note, const std::string& feedback);
Opinion wrong_answer(Slip slip);
Opinion half_right(Opinion opinion);
Opinion invalid(const Note& note, const std::string& feedback);
Opinion invalid(const language::SyntaxError& error, const std::string& text);
Opinion refused(Trouble trouble);
Opinion undecided(const std::string& reason);
/// Returns the question which of the readings is meant; `reason` is what is not clear.
Opinion ambiguous(const std::vector<std::string>& readings, const std::string& reason);
/// Returns the opinion on a text with these opinions on its readings: if all are right, or all are wrong in
/// the same way, the first; otherwise the question which is meant. `reason` is what is not clear.
Opinion opinion_on_all(const std::vector<Opinion>& readings, const std::string& reason);

/// Returns the exit code: 0 correct, 1 wrong, 2 invalid or ambiguous, 3 undecided.
int exit_code(const Opinion& opinion);
/// Returns whether an opinion is no verdict: the text could not be read, or not be decided.
bool needs_teacher(const Opinion& opinion);
/// Returns what to tell the student, in sentences with marks.
std::string feedback_of(const Opinion& opinion);

/// Return an opinion as text and read it again, for work in another process.
std::string packed(const Opinion& opinion);
Opinion unpacked(const std::string& text);

}  // namespace rederive::classroom
