// Converts trees to GiNaC expressions, and back.
#pragma once

#include <ginac/ginac.h>

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>

namespace rederive::language {

/// Returns the GiNaC expression of a tree. GiNaC simplifies as it builds, so only the tree has the form.
/// Throws SyntaxError: Mistake::undefined where rational arithmetic finds no real value (1/0, log(0),
/// sqrt(-1), asin(2)), too_large where a power would have too many digits. It does not check whether an
/// irrational constant is in the domain of a function, as in sqrt(3 - pi).
GiNaC::ex lower(const Tree& tree, const Symbols& symbols, const Limits& limits = {});

/// Returns the canonical tree of an expression, as a person would write it: constants, then symbols in the
/// order of their table, powers descending, no negative powers. Throws std::invalid_argument without one.
Tree to_tree(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive::language
