// The slips of students: their names, and the words that the program has for each. README.md says how to add
// one.
#pragma once

#include <string>

namespace rederive::classroom {

/// The slips that the program recognises by itself. `listed` is any other one, such as a slip that an
/// exercise lists under a word of its own.
enum class Slip {
  listed,
  // A part of a formula, as repairs.cpp finds it; of a number, as prepared.cpp does.
  sign,
  wrong_angle,
  wrong_argument,
  extra_term,
  missing_term,
  factor,
  taken_away,
  left_over,
  extra_factor,
  missing_factor,
  power,
  reciprocal,
  sin_cos,
  wrong_function,
  extra_function,
  absolute_value,
  wrong_symbol,
  exchanged,
  degrees,
  rounding,
  missing_dot,
  power_of_ten,
  // A whole answer, as why_wrong.cpp and judge_number.cpp find it.
  dimension,
  small_angle,
  not_linear,
  not_everywhere,
  missing_symbol,
  extra_symbol,
  unit,
  missing_unit,
  assumption,
  wrong_term,
  wrong_choice,
  other
};

/// The word under which an answer is counted: a slip, or another stable word, such as "syntax".
struct Note {
  Slip slip = Slip::listed;
  std::string word;

  Note() = default;
  Note(Slip which);
  /// Finds the slip of that word.
  Note(const std::string& stable_word);
};

/// The tables of slips.toml: what to say about a whole answer, a number, a part {} of a formula, and a
/// formula that is changed as a whole; and how to look for the slip.
enum class SlipTable { answer, number, part, whole, hint };

/// Reads slips.toml, if it was not read before. Throws BadInput, with file and line. Call it before work that
/// cannot open files.
void read_slip_words();
/// Returns what a table says about a note; "" if it says nothing.
std::string slip_words(SlipTable table, const Note& note);

}  // namespace rederive::classroom
