// Whether an expression is certainly 0 at a point, or beside it.
#pragma once

#include <derivations/algebra/evaluate.hpp>

namespace rederive {

/// An expression, as it is written and as the computer algebra has it.
struct Written {
  Tree tree;
  GiNaC::ex value;
};

/// A zero: the point itself; or one within 1e-40 of it, with what symbols really are there, as far as that
/// can be said: "pi/2", "sqrt(2)".
struct Root {
  Point at;
  bool exact;
  std::map<std::string, std::string> meant = {};
};

/// Whether there is a zero at the point or beside it: the computer algebra finds 0 when the point is put in,
/// or multiples of π or square roots that it stands for; or the sign changes along one symbol, within 1e-40,
/// and the values grow on either side as they do where there is no jump. That a value is small proves
/// nothing.
std::optional<Root> zero_near(const Written& expression, const Point& point, const Symbols& symbols);

/// Small enough for a root that is known to 40 digits.
bool is_tiny(const cln::cl_R& value);

/// 10^exponent, which is not negative.
cln::cl_I power_of_ten(int exponent);

/// A fraction of at most six digits that agrees with a number to so many decimal places.
std::optional<cln::cl_RA> simple_fraction(const cln::cl_RA& value, int places);

/// What to put in for the symbols.
GiNaC::exmap values_at(const Point& point, const Symbols& symbols);

}  // namespace rederive
