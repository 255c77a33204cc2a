// Sentences with mathematics in them: taken apart here, once for all output formats.
#pragma once

#include <derivations/paper/paper.hpp>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace rederive {

/// A stretch of a sentence.
struct Span {
  enum class Kind { text, math, code, emphasis, link };
  Kind kind;
  std::string text;         ///< without its marks; mathematics in our own syntax
  std::string target = {};  ///< of a link
};

/// Text between blank lines, with the white space inside made single blanks.
std::vector<std::string> paragraphs(std::string_view text);
/// Takes a sentence apart; passages.hpp lists the marks. Throws std::invalid_argument, with the sentence, if
/// a mark is not closed.
std::vector<Span> spans(std::string_view sentence);
/// Any text as a sentence, or as the part of one, in which no character is a mark.
std::string literal(std::string_view text);

/// A relation or expression in one of the notations of print.
std::string print_statement(const Relation& relation, Notation notation, const Symbols& symbols);
/// The same for mathematics inside a sentence, `$...$` without the dollars.
std::string print_inline(const std::string& text, Notation notation, const Symbols& symbols);

/// A sentence without its marks, mathematics in that notation.
std::string unmarked(const std::string& sentence, Notation notation, const Symbols& symbols);

/// A part of a long formula, with the sign before it: a relation sign, "+", "-", or none at the beginning.
struct Piece {
  std::string sign;
  Tree term;
  bool is_enclosed = false;  ///< in parentheses
};
/// Breaks a formula before its relation signs and before the terms of its sums.
std::vector<Piece> pieces(const Relation& relation);
/// A piece as text. Joined with blanks, the pieces are the whole formula.
std::string print(const Piece& piece, Notation notation, const Symbols& symbols);
/// A relation sign, "+" or "-" as a notation writes it.
std::string sign_text(const std::string& sign, Notation notation);

/// Words of a derivation's step taken apart: what stands between $…$ and can be read is mathematics, all else
/// is text.
std::vector<Span> step_spans(const std::string& words, const Symbols& symbols);

/// The words of a step, or of the ledger's notes, with marks put in. What stands between $…$ is mathematics;
/// so are names and calls such as cos(alpha - theta) where the paper says so (Paper::has_names_in_words):
/// those of other papers may be English words.
std::string marked(const std::string& words, const Paper& paper);

/// Letters and signs beyond ASCII written out, symbols by their names: "θ" → "theta", "–" → "-".
std::string to_ascii(std::string_view text, const Symbols& symbols);
/// Blanks made no-break spaces, so that wrap keeps the text in one piece.
std::string glued(const std::string& text);
/// The same with blanks again.
std::string unglued(std::string text);
/// Texts as one, with the same between them; `say` makes a text of an item.
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
/// "1 row", "2 rows".
inline std::string counted(std::size_t count, const std::string& name) {
  return std::to_string(count) + " " + name + (count == 1 ? "" : "s");
}
/// "(71) (86)".
inline std::string numbers_of(const std::vector<std::string>& ids) {
  return ids.empty() ? "" : "(" + joined(ids, ") (") + ")";
}
/// How many columns a UTF-8 text takes in a terminal; combining marks take none.
std::size_t columns(std::string_view text);
/// Breaks words into lines. A no-break space (U+00A0) stays inside its word and is printed as a blank.
std::string wrap(std::string_view words, std::size_t width, const std::string& first,
                 const std::string& rest);

}  // namespace rederive
