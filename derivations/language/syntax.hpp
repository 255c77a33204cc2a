// Reads text into a tree that keeps the form as written; README.md has the grammar.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <string_view>

namespace rederive {

/// Reads one expression. Names that `symbols` does not have are refused with the nearest known one, here and
/// below. Throws SyntaxError, "relation" where the text is a relation.
Tree parse(std::string_view text, const Symbols& symbols, const Limits& limits = {});
/// Reads a relation or a chain of them ("K = a = b"). Throws SyntaxError, "relation" where there is none.
Relation parse_relation(std::string_view text, const Symbols& symbols, const Limits& limits = {});
/// Reads either: an expression comes back as a Relation with one side and no operator. Throws SyntaxError.
Relation parse_statement(std::string_view text, const Symbols& symbols, const Limits& limits = {});

}  // namespace rederive
