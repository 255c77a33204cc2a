// Points inside the declared ranges, and witnesses: points where two statements differ beyond doubt.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/decide/proof.hpp>
#include <derivations/numbers/evaluate.hpp>

namespace rederive::decide {

/// The truth of a statement at a point; unknown if no precision decides it.
enum class Truth { holds, fails, undefined, unknown };
Truth truth_at(const language::Relation& relation, const numbers::Point& point, long bits = 1800);

/// The largest precision with which numbers are compared.
constexpr long bits_of_numbers = 16'000;

/// Collects constants at which something may change, such as rational parts that are not small or whole.
void collect_landmarks(const language::Tree& tree, std::vector<cln::cl_RA>& landmarks);

/// Returns the point with other values of some symbols, so that all equations hold. Each is solved for a
/// symbol that is linear or has a zero between two signs, in its range. `attempt` varies the order.
std::optional<numbers::Point> solve(const std::vector<language::Relation>& equations, numbers::Point point,
                                    const language::Symbols& symbols, int attempt);

/// Returns the tree with all coordinates put in except `but`; nullptr if one is a root between bounds.
language::Tree with_coordinates(language::Tree tree, const numbers::Point& point,
                                const std::string& but = {});

/// Returns both values at the point with 30 digits, or as many as distinguish them; nothing if that fails.
/// `of_left` says whether the point was found as a solution of the left statement, or of the right one.
std::optional<Witness> make_witness(const Problem& problem, const numbers::Point& point,
                                    std::optional<bool> of_left);

/// A point where the statements differ beyond doubt, all assumptions hold and all substituted values are in
/// the ranges of their symbols; and the number of points at which both have values and agree.
struct Search {
  std::optional<Witness> witness;
  int agreed = 0;
  std::optional<Witness> lacking = {};  ///< where exactly one certainly has no value
};
struct Effort {
  int points;
  int solutions;  ///< for relations: at so many points one is solved for a symbol
  long bits;      ///< largest precision, for statements with symbols
};
Search search(const Problem& problem, const Effort& effort);

}  // namespace rederive::decide
