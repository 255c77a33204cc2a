// Points inside the declared ranges at which two sides can be compared by hand.
#pragma once

#include <derivations/algebra/evaluate.hpp>
#include <derivations/algebra/interval.hpp>
#include <functional>
#include <set>
#include <vector>

namespace rederive {

/// The names that occur in a tree; pi is none.
void collect_names(const Tree& tree, std::set<std::string>& names);
/// The numbers that occur in a tree, and its constant parts.
void collect_numbers(const Tree& tree, std::set<double>& numbers);

/// A fixed sequence of rational points inside the declared ranges: small numbers first, then larger ones, at
/// last what is easily overlooked: the ends of ranges, and the sizes that the numbers of the statement
/// suggest.
class Points {
 public:
  static constexpr int count = 60;
  static constexpr int first_special = 28;  ///< from here on: the ends, and the sizes
  static constexpr int many =
      400;  ///< for what is defined in a corner only: the rest are small, and no longer special

  /// `names`: the symbols that get values; one that is not declared may be any real number. `numbers`: those
  /// of the statement. Those above 5 and those between 0 and 0.2 suggest sizes. Throws std::invalid_argument
  /// where a declared range cannot be read.
  Points(const std::set<std::string>& names, const Symbols& symbols, const std::set<double>& numbers = {});
  /// A value for every name, strictly inside its range. Any index from 0 on has a point, beyond `many`, too.
  Point at(int index) const;
  /// The point of that index, with 0 for every symbol that may be 0.
  Point with_zeros(int index) const;
  bool is_between(const std::string& name, double value) const;  ///< strictly inside the declared range
  /// The names that get values, sorted.
  std::vector<std::string> names() const;
  /// The ends that belong to the declared range; an irrational one is rounded, to 45 digits, into it.
  std::vector<cln::cl_RA> closed_ends(const std::string& name) const;

 private:
  struct Range {
    double low, high;
    std::vector<cln::cl_RA> closed_ends;
    std::optional<cln::cl_RA> above,
        below;  ///< the ends; irrational ones rounded, to 45 digits, into the range
  };
  static bool is_inside(const Range& range, const cln::cl_RA& value);
  static cln::cl_RA exactly_inside(const Range& range, double value, unsigned index, unsigned place);
  double ordinary(const Range& range, unsigned index, unsigned place) const;
  double special(const Range& range, unsigned index, unsigned place) const;

  std::map<std::string, Range> ranges_;
  std::vector<double> landmarks_;
};

/// Whether a value lies inside a declared range such as "(0, pi/2)", to 60 places.
bool is_inside(const std::string& range, const cln::cl_R& value);
/// Whether it lies between the ends, to all its digits.
bool is_strictly_inside(const std::string& range, const cln::cl_R& value);

/// The value of a tree, 0 included. 70 significant digits of value + 0.618033 are certain: that is about 70
/// decimal places of a small value, and fewer of a large one. Nothing where it has none, or where they cannot
/// be had.
std::optional<cln::cl_R> value_of(const Tree& tree, const Point& point);
/// "7/5"
std::string rational_text(const cln::cl_RA& value);
/// "1.4", or "7/5" where that has no end.
std::string decimal_text(const cln::cl_RA& value);

}  // namespace rederive
