// Along one symbol at a time: where does an expression change its sign?
#pragma once

#include <derivations/algebra/witness.hpp>

namespace rederive {

/// The zero between a and b, at which the values fa and fb differ in sign: exact rationals, rounded to so
/// many decimal places if the zero is no simple fraction. Nothing where the sign jumps, or a value is
/// missing.
std::optional<Point> polish(const Tree& tree, Point point, const std::string& name, cln::cl_RA a,
                            cln::cl_RA b, cln::cl_R fa, cln::cl_R fb, int places = 45);

/// The values that a symbol takes in the points, in order, with small whole numbers and the ends of its
/// range.
std::vector<cln::cl_RA> values_of(const std::string& name, const Points& points);

/// A walk along one symbol from each of a few points, to a zero that is wanted. Nothing once `most` changes
/// of sign have been seen.
std::optional<Point> walk(const Tree& tree, const Points& points, int most,
                          const std::function<bool(const Point&)>& wanted, int places = 45);

/// A point inside of the ranges at which the expression has the other sign, found by going down (or up, where
/// it is negative) from the one of the points at which it is smallest in size, along one symbol at a time, in
/// steps that are halved where none helps. Nothing where none is found, or there are more than four symbols.
std::optional<Point> across_zero(const Tree& tree, const Points& points, const Symbols& symbols);

}  // namespace rederive
