// GiNaC expression or tree → text; the same bytes on every run, in the order a person would choose.
#pragma once

#include <derivations/algebra/syntax.hpp>

namespace rederive {

enum class Notation { plain, unicode, latex };  ///< plain is our own syntax and can be parsed again

/// The canonical tree of an expression: constants, then the symbols in the order of their table, powers
/// descending, fractions for negative powers, no "+ -1*".
Tree to_tree(const GiNaC::ex& expression, const Symbols& symbols = paper_symbols());

/// A tree as text, in the form it has.
std::string print(const Tree& tree, Notation notation = Notation::plain, const Symbols& = paper_symbols());
/// Its sides and the operators between them: "a <= b", "a ≤ b", "a \\le b".
std::string print(const Relation& relation, Notation = Notation::plain, const Symbols& = paper_symbols());
/// print(to_tree(expression)).
std::string print(const GiNaC::ex& expression, Notation = Notation::plain, const Symbols& = paper_symbols());

}  // namespace rederive
