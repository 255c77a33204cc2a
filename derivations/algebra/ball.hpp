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

  bool is_of_pi() const { return !cln::zerop(of_pi); }
  /// The ends, exactly: floats of CLN that are added have the digits of the shorter one only.
  cln::cl_RA least() const { return cln::rational(middle) - cln::rational(radius); }
  cln::cl_RA most() const { return cln::rational(middle) + cln::rational(radius); }
  bool exact() const { return cln::zerop(radius) && cln:: instanceof (middle, cln::cl_RA_ring); }
};

/// Thrown where an operation has no real value, or where the ball is too wide to tell.
struct NoValue {};

/// The operations at one working precision, in decimal digits.
class BallArithmetic {
 public:
  explicit BallArithmetic(int digits);

  Ball pi() const;
  Ball negative(const Ball& x) const;
  Ball plus(const Ball& x, const Ball& y) const;
  Ball times(const Ball& x, const Ball& y) const;
  Ball over(const Ball& x, const Ball& y) const;  ///< NoValue if y may be 0
  Ball power(const Ball& x, const Ball& y) const;
  Ball absolute(const Ball& x) const;
  Ball sqrt(const Ball& x) const;
  Ball exp(const Ball& x) const;
  Ball log(const Ball& x) const;
  Ball sin(const Ball& x) const;
  Ball cos(const Ball& x) const;
  Ball sinh(const Ball& x) const;
  Ball cosh(const Ball& x) const;
  Ball atan(const Ball& x) const;
  Ball asin(const Ball& x) const;
  Ball asinh(const Ball& x) const;
  Ball acosh(const Ball& x) const;
  Ball atanh(const Ball& x) const;
  /// Any function of our syntax, by its name. Throws std::out_of_range for an unknown one.
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
