// Rational points inside the declared ranges, and what two statements say there, in ball arithmetic.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/decide/proof.hpp>
#include <derivations/numbers/evaluate.hpp>

namespace rederive {

/// The truth of a statement at a point; unknown where no precision tells.
enum class Truth { holds, fails, undefined, unknown };
Truth truth_at(const Relation& relation, const Point& point, long bits = 1800);

/// A point where the two statements differ beyond doubt, all assumptions hold and all values that were put in lie in
/// the ranges of their symbols; and how many points there were at which both have values and the same.
struct Search {
  std::optional<Witness> witness;
  int agreed = 0;
};
struct Effort {
  int points;
  long bits;    ///< up to so many
  bool solves;  ///< of equations, points that solve one of the two are tried, too
};
Search search(const Problem& problem, const Effort& effort);

}  // namespace rederive
