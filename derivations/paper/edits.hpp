// Changes of a formula in one part, for slips that are made (mutate.hpp) and slips that are looked for.
#pragma once

#include <derivations/language/tree.hpp>
#include <functional>

namespace rederive::edits {

Tree number(const std::string& digits);
Tree symbol(const std::string& name);
Tree negative(const Tree& tree);
Tree sum(const Tree& a, const Tree& b, bool minus = false);
Tree product(const Tree& a, const Tree& b, bool divide = false);
Tree call(const std::string& name, const Tree& argument);
/// How many parts it has.
std::size_t size_of(const Tree& tree);
/// The part of a product from one factor to another: b/c of a*b/c.
Tree part_of(const Tree& product, std::size_t first, std::size_t last);
/// The first and the last factor of each such part; nothing where the tree is no product.
std::vector<std::pair<std::size_t, std::size_t>> runs_of(const Tree& tree);
/// The tree with another function in the place of each.
Tree with_functions(const Tree& tree, const std::function<Tree(const Tree&)>& change);
/// A copy with another child at `index`.
Tree with_child(const Tree& tree, std::size_t index, const Tree& child);
/// A copy without the child at `index`.
Tree without_child(const Tree& tree, std::size_t index);
/// A copy with these terms subtracted for added, these factors as divisors.
Tree with_flipped(const Tree& tree, std::size_t first, std::size_t last);

}  // namespace rederive::edits
