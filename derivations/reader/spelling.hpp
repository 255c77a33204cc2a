// The spellings of students, before a text is split into tokens.
#pragma once

#include <derivations/language/tree.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rederive::reader {

/// A text in characters that the tokenizer knows, with the place in the typed text of every byte.
struct Spelt {
  std::string text;
  std::vector<std::size_t> places;  ///< one more than bytes
};

/// Rewrites LaTeX, brackets, bars, decimal commas, fractions in one character, primes, d/dt, signs for
/// degrees and percent. Throws SyntaxError for an empty placeholder, unknown commands and 1,234.5.
Spelt spell(std::string_view typed, const language::Limits& limits);

}  // namespace rederive::reader
