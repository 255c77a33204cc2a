// Points that solve an equation, and how a point is said.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/decide/proof.hpp>
#include <derivations/numbers/evaluate.hpp>

namespace rederive {

/// A symbol that is known as a zero between two numbers, not as a constant.
struct Zero {
  std::string symbol;
  cln::cl_RA low, high;
  Tree equals_zero;  ///< in the symbol alone
};

struct Solution {
  Point point;
  std::map<std::string, Tree> constants = {};  ///< the solved symbol, where it is a constant that is not rational
  std::optional<Zero> zero = {};
  std::optional<bool> of_left = {};  ///< whether it solves the left statement, or the right one
};

/// How an equation is solved: for a symbol that occurs linearly, or by a zero that a change of sign encloses.
enum class Way { linear, enclosed };

/// The point with another value of one symbol, such that the equation holds. Nothing where there is none in the range of
/// the symbol.
std::optional<Solution> solution_at(const Relation& equation, const std::string& symbol, const Point& point,
                                    const Symbols& symbols, Way way);

/// Both values at the point, to 30 digits; nothing where these cannot be had.
std::optional<Witness> make_witness(const Problem& problem, const Solution& solution);

}  // namespace rederive
