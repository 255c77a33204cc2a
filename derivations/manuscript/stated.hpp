// What a text says about its symbols, in simple words and in directives.
#pragma once

#include <derivations/manuscript/manuscript.hpp>
#include <map>
#include <optional>
#include <set>

namespace rederive::manuscript {

/// What is said of a name.
struct Stated {
  std::string range = "(-inf, inf)";
  bool is_integer = false, is_function = false, is_complex = false;
  bool is_from_text = false;  ///< otherwise from a directive or a file
};
using StatedSymbols = std::map<std::string, Stated>;

/// What a directive says besides: how the next display is judged.
struct Directive {
  bool is_identity = false;
  std::vector<std::string> from = {};  ///< labels
};

/// Reads "x > 0; n integer; theta in (-pi/2, pi/2); f function; z complex; identity; from eq:a, eq:b". Throws
/// BadInput for what cannot be read.
Directive read_directive(const std::string& text, StatedSymbols& symbols);

/// Reads a table [symbols] with `range`, `integer`, `function` and `complex`. Throws BadInput.
void read_symbols(const std::filesystem::path& file, StatedSymbols& symbols);

/// Returns the sentences of a text, each cut at 2,000 bytes, so that no expression is matched with a longer
/// one.
std::vector<std::string> sentences_of(std::string_view text);

/// Takes ranges such as "for $x > 0$", "where $n$ is an integer" and "positive $a$ and $b$" from prose.
void take_stated(const std::string& prose, StatedSymbols& symbols);

/// Takes a relation such as x > 0, 0 < x < 1, n in N as the range of a name. Returns whether it is
/// one.
bool take_range(const TexTokens& tokens, StatedSymbols& symbols, bool is_from_text);

}  // namespace rederive::manuscript
