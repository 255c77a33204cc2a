// Takes sentences apart and prints their parts, for all formats.
#pragma once

#include <derivations/paper/paper.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rederive::page {

/// A stretch of a sentence.
struct Span {
  enum class Kind { text, math, code, emphasis, link };
  Kind kind;
  std::string text;         ///< without its marks; mathematics in our own syntax
  std::string target = {};  ///< of a link
};

/// Returns the parts of a text between blank lines, in which all white space becomes single blanks.
std::vector<std::string> paragraphs(std::string_view text);
/// Takes a sentence apart; passages.hpp lists the marks. Throws std::invalid_argument, with the sentence, if
/// a mark is not closed.
std::vector<Span> spans(std::string_view sentence);
/// Returns any text as a sentence, or as a part of one, in which no character is a mark.
std::string literal(std::string_view text);

/// Returns a relation or an expression in a notation.
std::string print_statement(const language::Relation& relation, language::Notation notation,
                            const language::Symbols& symbols);
/// Returns the mathematics of a sentence, `$...$` without the dollars, in a notation.
std::string print_inline(const std::string& text, language::Notation notation,
                         const language::Symbols& symbols);

/// Returns a sentence without its marks.
std::string unmarked(const std::string& sentence, language::Notation notation,
                     const language::Symbols& symbols);

/// A part of a long formula, with the sign before it: a relation sign, "+", "-", or none at the beginning.
struct Piece {
  std::string sign;
  language::Tree term;
  bool is_enclosed = false;  ///< in parentheses
};
/// Breaks a formula before its relation signs and before the terms of its sums.
std::vector<Piece> pieces(const language::Relation& relation);
/// Returns a piece as text. Joined with blanks, the pieces are the whole formula.
std::string print(const Piece& piece, language::Notation notation, const language::Symbols& symbols);
/// Returns a relation sign, "+" or "-" as a notation writes it.
std::string sign_text(const std::string& sign, language::Notation notation);

/// Takes the words of a derivation's step apart. Text between $…$ that can be read is mathematics; all else
/// is text.
std::vector<Span> step_spans(const std::string& words, const language::Symbols& symbols);

/// Returns the words of a step, or of a note in the ledger, as a sentence. Text between $…$ is mathematics.
/// If Paper::has_names_in_words is true, so are names and calls such as cos(alpha - theta); in other papers
/// they may be English words.
std::string marked(const std::string& words, const paper::Paper& paper);

/// Returns a text in ASCII, with symbols by their names: "θ" becomes "theta", "–" becomes "-". Throws
/// std::invalid_argument for a character without a spelling.
std::string to_ascii(std::string_view text, const language::Symbols& symbols);
/// Returns a text with no-break spaces instead of blanks, so that `wrap` keeps it in one piece.
std::string glued(const std::string& text);
/// Returns a text with blanks instead of no-break spaces.
std::string unglued(std::string text);
/// Returns the texts of all items as one, with `between` between them. `say` returns the text of an item.
template <class Items, class Say = std::identity>
std::string joined(const Items& items, std::string_view between, Say say = {}) {
  std::string text;
  bool fresh = true;
  for (const auto& item : items) {
    text += (std::exchange(fresh, false) ? "" : between);
    text += say(item);
  }
  return text;
}
/// Returns a command on a paper as a user types it. "ledger show 3" is "build/bin/ledger show 3" for the
/// built-in paper and "rederive rod show 3" for a paper in the folder rod, where "exercises list" is
/// "rederive rod exercises list".
std::string command_on(const paper::Paper& paper, const std::string& command);
/// Returns "1 row" or "2 rows".
inline std::string counted(std::size_t count, const std::string& name) {
  return std::to_string(count) + " " + name + (count == 1 ? "" : "s");
}
/// Returns "(71) (86)".
inline std::string numbers_of(const std::vector<std::string>& ids) {
  return ids.empty() ? "" : "(" + joined(ids, ") (") + ")";
}
/// Returns how many columns a UTF-8 text takes in a terminal. Combining marks take none.
std::size_t columns(std::string_view text);
/// Breaks words into lines of at most `width` columns, of which the first begins with `first` and the others
/// with `rest`. A no-break space (U+00A0) does not break and is printed as a blank.
std::string wrap(std::string_view words, std::size_t width, const std::string& first,
                 const std::string& rest);

}  // namespace rederive::page
