// Compares formulas by their values at a few points. Changes of formulas are in derivations/paper/edits.hpp.
#pragma once

#include <derivations/decide/decide.hpp>
#include <derivations/numbers/evaluate.hpp>
#include <derivations/paper/edits.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace rederive::classroom {

using namespace paper::edits;

/// Returns what is printed with functions as students type them: abs, not fabs.
std::string as_typed(const std::string& printed);

/// Returns `count` points, or fewer if they are hard to find, that give every symbol an exact value in its
/// range, different values to the symbols in `names`, and at which `assumed` holds. Then the angles are
/// multiplied by `angles`: the rotations θ, and the shape α unless `rotations_only`.
std::vector<numbers::Point> sample_points(const std::set<std::string>& names, std::size_t count,
                                          const language::Symbols& symbols,
                                          const std::vector<language::Relation>& assumed,
                                          const cln::cl_RA& angles = 1, bool rotations_only = false);
/// Returns whether all relations, of two sides each, certainly hold at a point.
bool hold_at(const std::vector<language::Relation>& relations, const numbers::Point& point);

/// The values by which two statements are compared: of an expression, its values; of an equation with a
/// pivot, in which it must be linear, the values of the symbol `pivot` that solve it; of any other equation,
/// ratios of its residuals. Equal values suggest that a proof exists; they do not prove it.
using Signature = std::vector<double>;
/// Returns nothing if a value is undefined.
std::optional<Signature> signature(const language::Relation& statement, const std::string& pivot,
                                   const std::vector<numbers::Point>& points);
bool alike(const Signature& left, const Signature& right);

}  // namespace rederive::classroom
