// Exact interval arithmetic (Moore 1966): all values of an expression over ranges with open and closed ends.
#pragma once

#include <derivations/numbers/value.hpp>
#include <string_view>

namespace rederive::numbers {

/// One end of an interval: a + b*pi, or infinite (-1, +1). A closed end belongs to the interval.
struct End : Constant {
  int infinite = 0;
  bool closed = false;
};
/// Returns -1, 0 or +1: the order of two ends. Whether they are closed does not matter.
int compare(const End& x, const End& y);

/// A connected set of real numbers, empty if the ends are crossed. A result contains every value that the
/// operation has on the operands. An end that is not of the form a + b*pi is rational, further out, and open.
struct Interval {
  End low{{}, -1}, high{{}, +1};

  bool is_empty() const;
  bool contains(const Constant& x) const;
  bool contains_zero() const { return contains({}); }
  bool is_positive() const { return sign(low) > 0 || (sign(low) == 0 && !low.closed); }
  bool is_negative() const { return sign(high) < 0 || (sign(high) == 0 && !high.closed); }
  bool is_nonnegative() const { return sign(low) >= 0; }
  bool is_nonpositive() const { return sign(high) <= 0; }

 private:
  static int sign(const End& end) { return compare(end, {}); }
};

/// Returns the interval of one number.
Interval point(const Constant& x);
/// Returns a declared range, "(0, pi/2]" or "(-inf, 2*sqrt(2))". Throws std::invalid_argument.
Interval parse_range(std::string_view range);

Interval hull(const Interval& x, const Interval& y);     ///< the smallest that contains both
Interval overlap(const Interval& x, const Interval& y);  ///< what is in both; perhaps empty
bool is_within(const Interval& x, const Interval& y);    ///< whether y contains x

Interval operator+(const Interval& x, const Interval& y);
Interval operator-(const Interval& x);
Interval operator-(const Interval& x, const Interval& y);
Interval operator*(const Interval& x, const Interval& y);
Interval reciprocal(const Interval& x);                         ///< of the numbers that are not 0
Interval power(const Interval& x, const cln::cl_RA& exponent);  ///< of a fraction: where x >= 0
/// Returns the values of a function of our syntax. Throws std::out_of_range for an unknown function.
Interval call(const std::string& function, const Interval& x);

/// An interval on which a function is monotone, and the values at its ends, in this order. It is the whole
/// domain, except for circular functions and even functions.
struct MonotonePiece {
  Interval domain, values;
  std::string inverse;  ///< empty if the piece is not the whole domain and the function not circular
  int half_turn = 0;    ///< f(x + pi)/f(x) of a circular function, else 0
  Interval range = hull({values.low, values.low}, {values.high, values.high});
};
/// Throws std::out_of_range for an unknown function, and for one that is defined as 1/f.
const MonotonePiece& monotone_piece(const std::string& function);

}  // namespace rederive::numbers
