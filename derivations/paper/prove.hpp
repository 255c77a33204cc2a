// The decision procedure on anything that a user types.
#pragma once

#include <derivations/decide/decide.hpp>
#include <derivations/paper/paper.hpp>
#include <derivations/program/program.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive {

/// What was asked.
struct ProveRequest {
  std::string left, right;
  std::vector<std::string> assumptions;  ///< "x > 0", "0 < x < 1", "b < h", "x != 0", "theta = 0"
  std::vector<std::string> small;        ///< expansion symbols, with order
  std::optional<int> order;              ///< compare the series up to this order
};

/// The symbols of the paper, and every letter and Greek letter (with an index or dots) that the texts use.
/// These, and the paper's free letters, are any real numbers.
Symbols declared_symbols(const Paper& paper, const ProveRequest& request);

/// "x > 0", "x != y" as a relation. Throws BadInput, with a caret.
Relation read_assumption(const std::string& text, const Symbols& symbols);

/// What was asked, read. Throws BadInput, as `decide` does.
Problem problem_of(const Paper& paper, const ProveRequest& request);

/// Decides. Among the side conditions are the declared ranges and the assumed inequalities without which the
/// proof does not go through. Throws BadInput (with a caret) for what cannot be read, and for assumptions
/// that contradict each other.
Proof decide(const Paper& paper, const ProveRequest& request);

/// The message, the line and a caret under the character at fault: three lines for a terminal. A long line is
/// shown around that character.
std::string explain(const SyntaxError& error, std::string_view text);

/// A witness: "x = 2/5", "alpha = pi/6", "y between 0.739 and 0.740 where y - cos(y) = 0", "h ≈ 0.9449": a
/// text for every symbol.
std::vector<std::string> in_words(const Witness& witness);

/// Runs `read`; what it finds wrong with `text`, which a user typed, becomes BadInput, with a caret.
template <class Read>
auto reading(const std::string& text, Read read) {
  try {
    return read();
  } catch (const SyntaxError& error) {
    throw BadInput(explain(error, text));
  }
}

}  // namespace rederive
