// What the classroom does with a formula: changes a part of it (derivations/paper/edits.hpp), asks what it is
// worth at a few points.
#pragma once

#include <derivations/decide/decide.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/paper/edits.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rederive::classroom {

using namespace edits;

/// The tree with each named symbol replaced by what it stands for.
Tree put_in(const Tree& tree, const std::vector<Given>& given, const Symbols& symbols);
Relation put_in(const Relation& relation, const std::vector<Given>& given, const Symbols& symbols);

/// `count` points, or fewer where they are hard to find, that give every symbol an exact value in its range,
/// such that what is assumed holds there, no two of the named symbols alike; then the angles (or the
/// rotations θ alone, the shape α staying) are multiplied by `angles`.
std::vector<Point> sample_points(const std::set<std::string>& names, std::size_t count,
                                 const Symbols& symbols, const std::vector<Relation>& assumed,
                                 const cln::cl_RA& angles = 1, bool rotations_only = false);
/// Whether all of these, of two sides each, certainly hold at a point.
bool hold_at(const std::vector<Relation>& relations, const Point& point);

/// What stands for a statement when two are compared by their values: those of an expression, or those of the
/// symbol `pivot` that solve an equation linear in it; an equation without a pivot gives ratios of its
/// residuals. Nothing where that is undefined. Equal values are a reason to try a proof, never one
/// themselves.
using Signature = std::vector<double>;
std::optional<Signature> signature(const Relation& statement, const std::string& pivot,
                                   const std::vector<Point>& points);
bool alike(const Signature& left, const Signature& right);

}  // namespace rederive::classroom
