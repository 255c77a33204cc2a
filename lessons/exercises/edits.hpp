// Small builders, for those who edit trees.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <string>

namespace rederive::classroom {

Tree number(const std::string& digits);
Tree negative(const Tree& tree);
Tree scaled(const std::string& over, const std::string& under, const Tree& tree);
/// A copy with another child at `index`.
Tree with_child(const Tree& tree, std::size_t index, const Tree& child);
/// A copy without the child at `index`, or with it subtracted for added, a divisor for a factor.
Tree without_child(const Tree& tree, std::size_t index);
Tree with_flipped(const Tree& tree, std::size_t index);

}  // namespace rederive::classroom
