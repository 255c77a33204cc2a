// What the values of two sides at many points say: a difference refutes; agreement proves nothing.
#pragma once

#include <derivations/algebra/prove.hpp>
#include <derivations/algebra/witness.hpp>

namespace rederive {

/// The two things that are compared, after the givens have been put in, and what the givens ask of a point.
struct Pair {
  Tree left, right;
  GiNaC::ex left_value, right_value;
  std::vector<std::pair<std::string, Tree>> bound;  ///< a name that was replaced → what stands for it
  std::vector<Tree> never_zero = {};                ///< what was declared so, and Symbols::no_witness()
  std::string name = "";  ///< where the two are what one symbol is said to be: that symbol
};

/// The points at which the two are compared.
Points points_for(const std::vector<Tree>& trees, const Symbols& symbols);
Points points_for(const Pair& pair, const Symbols& symbols);
/// All that is looked at for a pair: both sides, and what a point must keep to.
std::vector<Tree> trees_of(const Pair& pair);
/// "; none was found of exp(10^9)": the smallest constant part of a pair that has no value, or one that is
/// too large to be found. Empty where there is no such part, or where it is too long to be repeated.
std::string without_value(const Pair& pair);

/// Whether a value is in the range; a closed end belongs to it. What is no rational number with a denominator
/// below 10^20 may be rounded, and may stand for an end or a pole: it must be more than 1e-30 away from the
/// ends (times its size, where that is above 1), and smaller than 1e30 in size.
bool is_well_inside(const std::string& range, const cln::cl_R& value);

/// Whether the point keeps every name that was replaced inside its declared range, and nothing is 0 that was
/// declared not to be.
bool is_admitted(const Pair& pair, const Point& point, const Symbols& symbols);

/// Where both are said to be the value of one symbol: whether one of them lies in its range. Outside, neither
/// can hold.
bool is_claimed(const Pair& pair, const cln::cl_R& left, const cln::cl_R& right, const Symbols& symbols);

/// Beyond all doubt: the difference is far above the accuracy of value_of.
bool differ(const cln::cl_R& a, const cln::cl_R& b);

/// The difference of both sides has a first digit that is not 0, however small it may be.
bool certainly_differ(const Pair& pair, const Point& point);

/// a - b as a tree.
Tree difference(const Tree& a, const Tree& b);

/// What is left at a root that is known to 45 digits.
bool is_nearly_zero(const cln::cl_R& value);

/// Both sides at a point, to 30 digits.
Witness make_witness(const Pair& pair, const Point& point);

/// A walk over Points that stops as soon as `enough` says so, or after `most` points.
struct Sample {
  int both = 0;                  ///< points where both sides have a value
  std::optional<Point> differs;  ///< the first where they differ
};
Sample sample(const Pair& pair, const Points& points, const Symbols& symbols,
              const std::function<bool(const Sample&)>& enough, int most = Points::count);

}  // namespace rederive
