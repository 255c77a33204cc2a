// Whether an expression is certainly 0 at a point, or beside it.
#pragma once

#include <derivations/algebra/evaluate.hpp>
#include <functional>

namespace rederive {

/// An expression, as it is written and as the computer algebra has it.
struct Written {
  Tree tree;
  GiNaC::ex value;
};

/// A zero: the point itself; or one in a box around it, of which is known what symbols are there, "pi/2" or
/// "sqrt(2)", or which equation they solve.
struct Root {
  Point at;
  bool exact;
  std::map<std::string, std::string> meant = {};  ///< "x" → "pi/2", where `at` has digits of it
  Box box = {};             ///< so narrow that 30 digits can be told; empty where the point is exact
  Box around = {};          ///< with `solves`: the same, or a wider one with shorter bounds
  std::string solves = {};  ///< "y-cos(y) = 0": what changes its sign in either box, if that is what is known
};

/// Whether there is a zero at the point or beside it: the computer algebra finds 0 when the point is put in,
/// or multiples of π, roots of rationals or a quotient that it stands for; or the sign certainly changes
/// along one symbol, within 1e-40, and the expression certainly has values all the way. That a value is small
/// proves nothing.
std::optional<Root> zero_near(const Written& expression, const Point& point, const Symbols& symbols);

/// What a constant is, to 45 decimal places; nothing of one above 1e20 in size.
std::optional<Between> bounds_of(const GiNaC::ex& constant, const Symbols& symbols);

/// The point at which the one symbol is a constant, rational or not; nothing where that is not in its range,
/// of which closed ends are a part.
std::optional<Root> place_of(const std::string& name, const GiNaC::ex& constant, const Symbols& symbols);

/// The root that is known by a change of sign, with the shortest bounds that `wanted` accepts around it.
Root with_short_bounds(Root root, const Written& expression, const Symbols& symbols,
                       const std::function<bool(const Root&)>& wanted);

/// Small enough for a root that is known to 40 digits.
bool is_tiny(const cln::cl_R& value);

/// 10^exponent, which is not negative.
cln::cl_I power_of_ten(int exponent);

/// A fraction of at most six digits that agrees with a number to so many decimal places.
std::optional<cln::cl_RA> simple_fraction(const cln::cl_RA& value, int places);

/// What to put in for the symbols.
GiNaC::exmap values_at(const Point& point, const Symbols& symbols);

}  // namespace rederive
