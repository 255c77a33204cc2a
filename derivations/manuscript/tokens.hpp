// Tokens of LaTeX, each with its place, and the macros that a manuscript defines.
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace rederive::manuscript {

/// A token, and the byte offset in the manuscript at which it begins. The token of a command whose argument
/// is words contains them: "\text{for all}", "\begin{align}", "\label{eq:1}".
struct TexToken {
  std::string text;
  std::size_t place;
  std::size_t end = 0;  ///< behind it, if it is not as long as its text

  bool is(std::string_view word) const { return text == word; }
  bool starts(std::string_view word) const { return text.starts_with(word); }
  /// Returns the words in braces of such a token: "for all".
  std::string words() const;
};
using TexTokens = std::vector<TexToken>;

/// Splits LaTeX from `from` on into tokens, without blanks, comments and commands that only set type.
TexTokens tokens_of(std::string_view text, std::size_t from, std::size_t to);

/// A macro, as newcommand and def make them.
struct Macro {
  std::size_t arguments = 0;
  std::optional<TexTokens> usual = {};  ///< the value of the first argument if it is left out
  TexTokens body;
};
using Macros = std::map<std::string, Macro>;

/// Reads a definition that begins at tokens[at], and returns the place behind it; `at` for other tokens.
std::size_t read_macro(const TexTokens& tokens, std::size_t at, Macros& macros);

/// Returns the tokens with macros replaced; their values have the place of the call. `budget` is
/// the number of calls that are still replaced in the manuscript, so that macros that call themselves end.
TexTokens expanded(const TexTokens& tokens, const Macros& macros, std::size_t& budget);

/// Returns the index behind the group in braces or the token at `at`.
std::size_t behind_argument(const TexTokens& tokens, std::size_t at);

}  // namespace rederive::manuscript
