// derivations.json: the derivations of a paper as data.
//
//   {"format": 1, "digest": "…", "derivations": {"2": {"left": "thetaddot", "relation": "=", "right": "…",
//    "steps": [{"says": "…", "left": "…", "relation": "=", "right": "…"}, {"says": "…", "cites": "1"}],
//    "given": [["J", "m*L^2/3"]], "assumption": "", "order": 0, "small": "", "stated": false},
//    "3": {"error": "derive.py:17: …"}}}
//
// Expressions are texts in our own syntax. A derivation that failed has its error alone.
#pragma once

#include <derivations/paper/derivations.hpp>
#include <filesystem>
#include <string>

namespace rederive::paper {

/// Returns the derivations in a file, whose expressions are read with `symbols` when they are first asked
/// for: an expression that cannot be read is an error of its row alone. Throws BadInput, with the file and
/// the row, if the file does not have the form above.
Derivations read_derivations(const std::filesystem::path& file, const language::Symbols& symbols);

/// Returns the text of such a file. A derivation that throws becomes an error of its row.
std::string derivations_text(const Derivations& rows, const language::Symbols& symbols,
                             const std::string& digest);

/// Returns the digest in a file; "" if there is no file or no digest in it.
std::string digest_in(const std::filesystem::path& file);

}  // namespace rederive::paper
