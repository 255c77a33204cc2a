// The second opinion: the value of a tree at a rational point, to many digits, by CLN alone. Uses nothing of
// the rewriting in prove, which asks it for the signs of constants.
#pragma once

#include <cln/cln.h>

#include <derivations/algebra/ball.hpp>
#include <derivations/algebra/decimal.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <map>
#include <optional>
#include <string>

namespace rederive {

using Point = std::map<std::string, cln::cl_RA>;  ///< symbol name → exact value

/// The real value of `tree` at `point`, computed with `digits` decimal digits and guard digits; nothing where
/// it is undefined or not real there (a zero divisor, the square root of a negative number, tan at π/2), or
/// where the exponents grow beyond reason. Throws std::out_of_range for a symbol that `point` does not give.
std::optional<cln::cl_R> evaluate(const Tree& tree, const Point& point, int digits);

/// All numbers from one to another.
struct Between {
  cln::cl_RA low, high;
};
using Box = std::map<std::string, Between>;  ///< symbol name → what it is not known better than

/// Holds the values that `tree` has while the symbols of the box take any values within their bounds, and the
/// others are what `point` says. There it has a value everywhere and is continuous; nothing where that is not
/// certain, at about 110 digits.
std::optional<Ball> enclosure(const Tree& tree, const Point& point, const Box& box);

/// Half a unit in the last of so many significant digits is more than the radius.
bool is_certain(const Ball& ball, int digits);

}  // namespace rederive
