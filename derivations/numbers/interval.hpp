// Exact interval arithmetic (Moore 1966): all values of an expression over ranges, with open and closed ends.
#pragma once

#include <derivations/numbers/value.hpp>
#include <string_view>

namespace rederive {

/// One end of an interval: a + b*pi, or infinite (-1, +1). A closed end belongs to it.
struct End : Constant {
  int infinite = 0;
  bool closed = false;
};
/// -1, 0, +1: the order of two ends, whether closed or not.
int compare(const End& x, const End& y);

/// A connected set of real numbers; empty where the ends are crossed. A result holds every value that the
/// operation has on the operands; an end that is not again a + b*pi is rational, further out, and open.
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

/// The one number.
Interval point(const Constant& x);
/// Reads a declared range: "(0, pi/2]", "(-inf, 2*sqrt(2))". Throws std::invalid_argument.
Interval parse_range(std::string_view range);

Interval hull(const Interval& x, const Interval& y);     ///< the smallest that holds both
Interval overlap(const Interval& x, const Interval& y);  ///< what lies in both; perhaps empty
bool is_within(const Interval& x, const Interval& y);    ///< whether all of x lies in y

Interval operator+(const Interval& x, const Interval& y);
Interval operator-(const Interval& x);
Interval operator-(const Interval& x, const Interval& y);
Interval operator*(const Interval& x, const Interval& y);
Interval reciprocal(const Interval& x);  ///< of those that are not 0
Interval power(const Interval& x,
               const cln::cl_RA& exponent);  ///< a fraction: of those that are not negative
/// The values of a function of our syntax, where it has values. Throws std::out_of_range for another name.
Interval call(const std::string& function, const Interval& x);

/// A piece of the line on which a function is monotone: its whole domain, but of circular functions and of
/// even ones; and the values at the ends of it, in this order.
struct MonotonePiece {
  Interval domain, values;
  const char* inverse;  ///< null where the piece is not the whole domain, circular functions excepted
  int half_turn = 0;    ///< f(x + pi)/f(x) of a circular function, else 0
  Interval range = hull({values.low, values.low}, {values.high, values.high});
};
/// Throws std::out_of_range for an unknown name, and for those that are defined as 1/f.
const MonotonePiece& monotone_piece(const std::string& function);

}  // namespace rederive
