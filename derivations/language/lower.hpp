// Tree ⇄ the GiNaC expression that it stands for.
#pragma once

#include <ginac/ginac.h>

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>

namespace rederive {

/// GiNaC simplifies as it builds: ask the tree about form. Throws SyntaxError "undefined" where rational
/// arithmetic meets what has no real value (1/0, log(0), sqrt(-1), asin(2)), "too_large" where a power would
/// make a number of more digits than anybody wants. Whether an irrational constant is in the domain of a
/// function, as in sqrt(3 - pi), is not looked at.
GiNaC::ex lower(const Tree& tree, const Symbols& symbols, const Limits& limits = {});

/// The canonical tree of an expression, as a person would write it: constants, then the symbols in the order
/// of their table, powers descending, no negative powers. Throws std::invalid_argument where there is none.
Tree to_tree(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive
