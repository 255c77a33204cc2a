// What the classroom does with a formula: changes a part of it, asks what it is worth at a few points.
#pragma once

#include <derivations/decide/decide.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rederive::classroom {

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

/// The tree with each named symbol replaced by what it stands for.
Tree put_in(const Tree& tree, const std::vector<Given>& given);
Relation put_in(const Relation& relation, const std::vector<Given>& given);

/// `count` points that give every symbol of the paper an exact value, no two of the named ones alike; the
/// angles (or the rotations θ alone, the shape α staying) are multiplied by `angles`.
std::vector<Point> sample_points(const std::set<std::string>& names, std::size_t count,
                                 const cln::cl_RA& angles = 1, bool rotations_only = false);

/// What stands for a statement when two are compared by their values: those of an expression, or those of the
/// symbol `pivot` that solve an equation linear in it; an equation without a pivot gives ratios of its
/// residuals. Nothing where that is undefined. Equal values are a reason to try a proof, never one
/// themselves.
using Signature = std::vector<double>;
std::optional<Signature> signature(const Relation& statement, const std::string& pivot,
                                   const std::vector<Point>& points);
bool alike(const Signature& left, const Signature& right);

}  // namespace rederive::classroom
