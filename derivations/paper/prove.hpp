// The decision procedure on anything that a user types.
#pragma once

#include <derivations/decide/decide.hpp>
#include <derivations/paper/paper.hpp>
#include <derivations/program/program.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::paper {

/// A request to prove a statement, as it was typed.
struct ProveRequest {
  std::string left, right;
  std::vector<std::string> assumptions;  ///< "x > 0", "0 < x < 1", "b < h", "x != 0", "theta = 0"
  std::vector<std::string> small;        ///< expansion symbols, with order
  std::optional<int> order;              ///< compare the series up to this order
  bool generous = false;                 ///< read what people write: 2x, sin x, LaTeX
};

/// The symbols of the paper, and every letter and Greek letter (with an index or dots) that the texts use.
/// These, and the paper's free letters, are any real numbers.
language::Symbols declared_symbols(const Paper& paper, const ProveRequest& request);

/// Returns "x > 0", "x != y" as a relation. Throws BadInput, with a caret.
language::Relation read_assumption(const std::string& text, const language::Symbols& symbols);

/// Returns the problem of a request. Throws BadInput, as `decide` does.
decide::Problem problem_of(const Paper& paper, const ProveRequest& request);

/// Decides. Among the side conditions are the declared ranges and the assumed inequalities without which the
/// proof does not go through. Throws BadInput (with a caret) for what cannot be read, and for assumptions
/// that contradict each other.
decide::Proof decide(const Paper& paper, const ProveRequest& request);

/// The stable word under which a mistake is tallied: "unknown_symbol".
std::string word_of(language::Mistake mistake);
/// What a proof rests on: "identity" …; "" for nothing.
std::string word_of(decide::By by);

/// The message, the line and a caret under the character at fault: three lines for a terminal. A long line is
/// shown around that character.
std::string explain(const language::SyntaxError& error, std::string_view text);
/// The same, with how the strict grammar writes a text in which a sign or a parenthesis is missing.
std::string explain(const language::SyntaxError& error, std::string_view text,
                    const language::Symbols& symbols);

/// A witness: "x = 2/5", "alpha = pi/6", "y between 0.739 and 0.740 where y - cos(y) = 0", "h ≈ 0.9449": a
/// text for every symbol.
std::vector<std::string> in_words(const decide::Witness& witness);

/// Runs `read`; what it finds wrong with `text`, which a user typed, becomes BadInput, with a caret.
template <class Read>
auto reading(const std::string& text, const language::Symbols& symbols, Read read) {
  try {
    return read();
  } catch (const language::SyntaxError& error) {
    throw program::BadInput(explain(error, text, symbols));
  }
}

}  // namespace rederive::paper
