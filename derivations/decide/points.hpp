// Points inside the declared ranges, and a witness: a point where two statements differ beyond doubt.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/decide/proof.hpp>
#include <derivations/numbers/evaluate.hpp>

namespace rederive {

/// The truth of a statement at a point; unknown where no precision tells.
enum class Truth { holds, fails, undefined, unknown };
Truth truth_at(const Relation& relation, const Point& point, long bits = 1800);

/// The most bits with which numbers are compared.
constexpr long bits_of_numbers = 16'000;

/// The constant parts that are rational and neither small nor whole, and some more: where something may turn.
void collect_landmarks(const Tree& tree, std::vector<cln::cl_RA>& landmarks);

/// The point with other values of some symbols, such that all equations hold, each solved for one symbol that
/// occurs linearly or has a zero between two signs, in its range. `attempt` varies which are tried first.
std::optional<Point> solve(const std::vector<Relation>& equations, Point point, const Symbols& symbols,
                           int attempt);

/// The tree with every coordinate put in but `but`; nullptr where a coordinate is a root between bounds.
Tree with_coordinates(Tree tree, const Point& point, const std::string& but = {});

/// Both values at the point, to 30 digits, or to as many as tell them apart; nothing where these cannot be
/// had. `of_left`: whether the point was found as one that solves the left statement, or the right one.
std::optional<Witness> make_witness(const Problem& problem, const Point& point, std::optional<bool> of_left);

/// A point where the two statements differ beyond doubt, all assumptions hold and all values that were put in
/// lie in the ranges of their symbols; and how many points there were at which both have values and the same.
struct Search {
  std::optional<Witness> witness;
  int agreed = 0;
  std::optional<Witness> lacking = {};  ///< where one has values, and the other one certainly has none
};
struct Effort {
  int points;
  int solutions;  ///< of relations: at so many points one is also solved for a symbol
  long bits;      ///< up to so many, of statements with symbols
};
Search search(const Problem& problem, const Effort& effort);

}  // namespace rederive
