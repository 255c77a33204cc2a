// GiNaC expression → the tree that a person would write.
#pragma once

#include <ginac/ginac.h>

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>

namespace rederive {

/// The canonical tree of an expression: constants, then the symbols in the order of their table, powers
/// descending, fractions for negative powers, no "+ -1*". Throws std::invalid_argument for what our syntax
/// cannot write.
Tree to_tree(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive
