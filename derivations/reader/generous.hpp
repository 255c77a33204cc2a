// Reads what students write: implicit products, functions without parentheses, LaTeX, units, rates as primes.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace rederive::reader {

using language::Limits;
using language::Relation;
using language::Symbols;

/// What a reader of answers knows besides the symbols.
struct Vocabulary {
  const Symbols& symbols;
  std::vector<std::string> given =
      {};              ///< symbols that may occur; all if empty. e is exp(1) if it is not given
  bool units = false;  ///< the symbols are units: m/s2 is m/s^2, and 2.69 1/s is 2.69/s
};

/// The ways in which a text can be read, in the order in which a reader thinks of them.
struct Readings {
  std::vector<Relation> all;  ///< at least one; they differ in value
  std::string reason = {};    ///< "where the argument of a function ends"; empty for one reading
};

/// Reads an expression or a relation. A text in our own syntax has the one reading of parse_statement(), and
/// so has any text that print() wrote. Throws SyntaxError for what cannot be read; the place is in `text`.
Readings generous_readings(std::string_view text, const Vocabulary& reader, const Limits& limits = {});

/// Returns how a text that the strict grammar refuses is written, ": write 2*x" or ": write a/b*c or
/// a/(b*c)";
/// "; … is not clear" if it has more than two readings; "" if it cannot be read or is long, and for errors
/// that are not about signs, parentheses and notations.
std::string advice(const language::SyntaxError& error, std::string_view text, const Symbols& symbols);

}  // namespace rederive::reader
