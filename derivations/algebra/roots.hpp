// Where an expression is 0: at a rational point exactly, or between two points with values of opposite signs.
#pragma once

#include <derivations/algebra/witness.hpp>

namespace rederive {

/// An expression, as it is written and as the computer algebra has it.
struct Written {
  Tree tree;
  GiNaC::ex value;
};

/// A zero: the point itself, or one within 1e-40 of it.
struct Root {
  Point at;
  bool exact;
};

/// Whether there is a zero at the point or beside it: the computer algebra finds 0 when the point is put in;
/// or the sign changes along one symbol, within 1e-40, and the values grow on either side as they do where
/// there is no jump. That a value is small proves nothing.
std::optional<Root> zero_near(const Written& expression, const Point& point, const Symbols& symbols);

/// Which roots are looked for: where the sign changes, or where it does not, too.
enum class Roots { crossings, all };

/// The exact zeros, near some Points::at, of what is linear in one symbol, however far away; with that
/// symbol.
std::vector<std::pair<std::string, Point>> linear_zeros(const GiNaC::ex& expression, const Points& points,
                                                        const Symbols& symbols);

/// A zero that `wanted` accepts, near some Points::at, or where the expression is linear in one symbol. Gives
/// up after `most` changes of sign.
std::optional<Root> find_root(const Written& expression, const Points& points, int most, Roots which,
                              const Symbols& symbols, const std::function<bool(const Root&)>& wanted);

}  // namespace rederive
