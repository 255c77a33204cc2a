// Changes of a formula in one part, for slips that are made (mutate.hpp) and slips that are looked for.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <functional>

namespace rederive::paper::edits {

language::Tree number(const std::string& digits);
language::Tree symbol(const std::string& name);
language::Tree negative(const language::Tree& tree);
language::Tree sum(const language::Tree& a, const language::Tree& b, bool minus = false);
language::Tree product(const language::Tree& a, const language::Tree& b, bool divide = false);
language::Tree call(const std::string& name, const language::Tree& argument);
/// Returns the number of parts of a tree.
std::size_t size_of(const language::Tree& tree);
/// The part of a product from one factor to another: b/c of a*b/c.
language::Tree part_of(const language::Tree& product, std::size_t first, std::size_t last);
/// The first and the last factor of each such part; nothing if the tree is not a product.
std::vector<std::pair<std::size_t, std::size_t>> runs_of(const language::Tree& tree);
/// The tree with another function in the place of each.
language::Tree with_functions(const language::Tree& tree,
                              const std::function<language::Tree(const language::Tree&)>& change);
/// A copy with another child at `index`.
language::Tree with_child(const language::Tree& tree, std::size_t index, const language::Tree& child);
/// A copy without the child at `index`.
language::Tree without_child(const language::Tree& tree, std::size_t index);
/// A copy with these terms subtracted for added, these factors as divisors.
language::Tree with_flipped(const language::Tree& tree, std::size_t first, std::size_t last);

/// Returns the tree or relation with each symbol of `given` replaced by its value.
language::Tree put_in(const language::Tree& tree, const std::vector<language::Given>& given,
                      const language::Symbols& symbols);
language::Relation put_in(const language::Relation& relation, const std::vector<language::Given>& given,
                          const language::Symbols& symbols);
/// Returns the tree as a person writes it after a change of one part: products within products and sums
/// within sums are one, and a number that the change put before a part is joined to the sign or the numbers
/// there.
language::Tree tidied(const language::Tree& tree);

}  // namespace rederive::paper::edits
