// The slips of a pen: every way to change one place of a formula as students do.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <string>
#include <vector>

namespace rederive::classroom {

struct Edit {
  Tree tree;
  std::string note;  ///< sign, wrong_angle, missing_term, factor, power, sin_cos, missing_dot, missing_factor
};

/// Every tree that differs from this one by one slip.
std::vector<Edit> edits(const Tree& tree);
/// The same for a relation; each result has the same shape.
struct RelationEdit {
  Relation relation;
  std::string note;
};
std::vector<RelationEdit> edits(const Relation& relation);

/// Small builders, for those who edit trees.
Tree number(const std::string& digits);
Tree negative(const Tree& tree);
Tree scaled(const std::string& over, const std::string& under, const Tree& tree);
/// A copy with another child at `index`.
Tree with_child(const Tree& tree, std::size_t index, const Tree& child);
/// A copy without the child at `index`, or with it subtracted for added, a divisor for a factor.
Tree without_child(const Tree& tree, std::size_t index);
Tree with_flipped(const Tree& tree, std::size_t index);

}  // namespace rederive::classroom
