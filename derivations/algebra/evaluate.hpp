// The second opinion: the value of a tree at a rational point, to many digits, by CLN alone. Shares no code
// with the rewriting in prove.
#pragma once

#include <cln/cln.h>

#include <derivations/algebra/syntax.hpp>
#include <map>
#include <optional>
#include <string>

namespace rederive {

using Point = std::map<std::string, cln::cl_RA>;  ///< symbol name → exact value

/// The real value of `tree` at `point`, computed with `digits` decimal digits and guard digits; nothing where
/// it is undefined or not real there (a zero divisor, the square root of a negative number, tan at π/2), or
/// where the exponents grow beyond reason. Throws std::out_of_range for a symbol that `point` does not give.
std::optional<cln::cl_R> evaluate(const Tree& tree, const Point& point, int digits);

/// "0.785398163397448309615660845820", with `digits` significant digits, rounded.
std::string decimal(const cln::cl_R& value, int digits);

}  // namespace rederive
