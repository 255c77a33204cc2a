// Reads a text into a tree that keeps the form as written; README.md has the grammar.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <string_view>

namespace rederive::language {

/// Returns the tree of an expression. Throws SyntaxError: for a name that `symbols` lacks, with the nearest
/// known one; Mistake::relation if the text is a relation.
Tree parse(std::string_view text, const Symbols& symbols, const Limits& limits = {});
/// Returns a relation, or a chain ("K = a = b"). Throws SyntaxError, also for an expression.
Relation parse_relation(std::string_view text, const Symbols& symbols, const Limits& limits = {});
/// Returns either; an expression becomes a Relation with one side and no operator. Throws SyntaxError.
Relation parse_statement(std::string_view text, const Symbols& symbols, const Limits& limits = {});

}  // namespace rederive::language
