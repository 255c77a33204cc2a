// The slips of students: their names, and the words that the program has for each. README.md says how to add
// one.
#pragma once

#include <derivations/paper/repairs.hpp>
#include <string>

namespace rederive::classroom {

using paper::Slip;

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
