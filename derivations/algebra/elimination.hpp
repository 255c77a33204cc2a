// Equations that hold together, solved one after another for a symbol in which they are linear.
#pragma once

#include <derivations/algebra/evaluate.hpp>
#include <optional>
#include <set>
#include <vector>

namespace rederive {

/// The names of the symbols in an expression.
std::set<std::string> names_in(const GiNaC::ex& expression);

/// What some symbols are where all the equations hold, in terms of those that are left free.
using Solution = std::vector<std::pair<std::string, GiNaC::ex>>;

/// Residuals that are to be 0 together. Of equations and symbols those come first whose coefficient is a
/// number, in the order of the alphabet. Nothing where an equation is linear in no symbol that is left.
std::optional<Solution> solved(std::vector<GiNaC::ex> residuals, const Symbols& symbols);

/// The point with the solved symbols as the free ones have them; nothing where one is not rational there, or
/// outside of its range.
std::optional<Point> completed(const Solution& solution, Point point, const Symbols& symbols);

}  // namespace rederive
