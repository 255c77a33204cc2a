// Prints expressions and trees: the same bytes on every run, in the order that a person would choose.
#pragma once

#include <derivations/language/lower.hpp>

namespace rederive::language {

enum class Notation { plain, unicode, latex };  ///< plain is our own syntax and can be parsed again

/// A tree as text, in the form it has.
std::string print(const Tree& tree, Notation notation, const Symbols& symbols);
/// Its sides and the operators between them: "a <= b", "a ≤ b", "a \\le b".
std::string print(const Relation& relation, Notation notation, const Symbols& symbols);
/// The same in our own syntax, in which symbols are written by their names.
inline std::string print(const Tree& tree) { return print(tree, Notation::plain, {}); }
inline std::string print(const Relation& relation) { return print(relation, Notation::plain, {}); }
/// Returns print(to_tree(expression)).
std::string print(const GiNaC::ex& expression, Notation notation, const Symbols& symbols);

}  // namespace rederive::language
