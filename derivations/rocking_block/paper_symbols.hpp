// The symbols of the paper, and the language with these symbols.
#pragma once

#include <derivations/language/dimension.hpp>
#include <derivations/language/explain.hpp>
#include <derivations/language/lower.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>

namespace rederive {

/// The symbols of the paper, with their meanings: the one table that everything else reads.
const Symbols& paper_symbols();

inline Tree parse(std::string_view text) { return parse(text, paper_symbols()); }
inline Relation parse_relation(std::string_view text) { return parse_relation(text, paper_symbols()); }
inline Relation parse_statement(std::string_view text) { return parse_statement(text, paper_symbols()); }
inline GiNaC::ex lower(const Tree& tree) { return lower(tree, paper_symbols()); }
inline Tree to_tree(const GiNaC::ex& expression) { return to_tree(expression, paper_symbols()); }
/// Of a Tree, a Relation or a GiNaC::ex.
template <class Formula>
std::string print(const Formula& formula, Notation notation = Notation::plain) {
  return print(formula, notation, paper_symbols());
}
/// Of a Tree or a Relation.
template <class Formula>
DimensionReport dimension(const Formula& formula) {
  return dimension(formula, paper_symbols());
}

}  // namespace rederive
