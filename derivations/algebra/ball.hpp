// Real numbers with a proven error bound: every operation on balls gives a ball that holds all the true
// values.
#pragma once

#include <cln/cln.h>

#include <string>

namespace rederive {

/// All reals within `radius` of `middle`. A rational middle with radius 0 is exact.
struct Ball {
  cln::cl_R middle;
  cln::cl_R radius = 0;
  cln::cl_RA of_pi = 0;  ///< where it is not 0, the value is known to be this rational multiple of π

  /// Whether it is known to be a rational multiple of π other than 0.
  bool is_of_pi() const { return !cln::zerop(of_pi); }
  /// The ends, exactly: floats of CLN that are added have the digits of the shorter one only.
  cln::cl_RA least() const { return cln::rational(middle) - cln::rational(radius); }
  cln::cl_RA most() const { return cln::rational(middle) + cln::rational(radius); }
  /// Whether it is one rational number, the middle.
  bool exact() const { return cln::zerop(radius) && cln:: instanceof (middle, cln::cl_RA_ring); }
};

/// Thrown where an operation has no real value, or where the ball is too wide to tell.
struct NoValue {
  bool is_certain = false;  ///< else more digits may give one
};

/// The operations at one working precision. What is said of NoValue is so for narrow balls; wide ones may be
/// refused elsewhere, too. Where numbers grow too large for CLN, its cln::runtime_exception passes.
class BallArithmetic {
 public:
  /// `digits`: decimal ones, more than 0.
  explicit BallArithmetic(int digits);

  /// What these are of all numbers in the balls.
  Ball pi() const;
  Ball negative(const Ball& x) const;
  Ball plus(const Ball& x, const Ball& y) const;
  Ball times(const Ball& x, const Ball& y) const;
  Ball over(const Ball& x, const Ball& y) const;  ///< NoValue if y may be 0
  /// For exact whole numbers y up to 10,000 in size: NoValue if x may be 0 and y is not positive. Any other
  /// power is one of sqrt(x), or exp(y*log(x)): NoValue unless x is certainly positive, or exactly 0 and y
  /// certainly positive.
  Ball power(const Ball& x, const Ball& y) const;
  Ball absolute(const Ball& x) const;
  Ball sqrt(const Ball& x) const;  ///< NoValue unless x is certainly positive, or exactly 0
  Ball exp(const Ball& x) const;   ///< NoValue beyond a million in size, or for a radius above 1
  Ball log(const Ball& x) const;   ///< NoValue unless x is certainly positive
  Ball sin(const Ball& x) const;   ///< NoValue beyond 10^digits in size, where no exact value is known
  Ball cos(const Ball& x) const;   ///< as sin
  Ball sinh(const Ball& x) const;  ///< NoValue as exp
  Ball cosh(const Ball& x) const;  ///< as sinh
  Ball atan(const Ball& x) const;
  Ball asin(const Ball& x) const;  ///< NoValue unless x is certainly between -1 and 1, or exactly one of them
  Ball asinh(const Ball& x) const;
  Ball acosh(const Ball& x) const;  ///< NoValue unless x is certainly above 1, or exactly 1
  Ball atanh(const Ball& x) const;  ///< NoValue unless x is certainly between -1 and 1
  /// Any function of our syntax of one argument, by its name; "fabs" for "abs". NoValue as above, and where a
  /// divisor may be 0, as of tan at π/2. Throws std::out_of_range for an unknown one.
  Ball call(const std::string& function, const Ball& x) const;

 private:
  cln::cl_R rough(const cln::cl_R& x) const;  ///< to few digits: enough for a radius
  cln::cl_F fine(const cln::cl_R& x) const;   ///< to the working precision
  cln::cl_F reducible(const Ball& x) const;
  Ball rounded(const cln::cl_R& middle, const cln::cl_R& radius) const;
  Ball whole_power(const Ball& x, const cln::cl_I& n) const;

  cln::float_format_t format_;
  cln::cl_R unit_;   ///< more than the relative error of one operation
  cln::cl_R slack_;  ///< more than 1 by more than the relative error of what is rough
};

/// Whether it is certain that x > 0, x < 0.
bool is_positive(const Ball& x);
bool is_negative(const Ball& x);
/// Whether it is certain that the function has no real value there: log(0), asin(2).
bool is_outside_domain(const std::string& function, const Ball& x);

}  // namespace rederive
