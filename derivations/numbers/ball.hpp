// Real numbers with a proven bound, by Arb: Johansson, "Arb: efficient arbitrary-precision midpoint-radius
// interval arithmetic", IEEE Trans. Comput. 66 (2017).
#pragma once

#include <arb.h>
#include <cln/integer.h>
#include <cln/rational.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace rederive {
std::string decimal(const cln::cl_R& value, int digits);  // of the language
}

namespace rederive::inline numbers {  // inline as long as the old engine has the same names

/// A real number known to lie in [mid - rad, mid + rad], and the bits at which one computes with it. A result
/// holds every value that the operation has on the operands; where it has none somewhere, it is not finite.
class Ball {
 public:
  using ArbFunction = void (*)(arb_t, const arb_t, slong);

  Ball() { arb_init(x_); }
  explicit Ball(long n) : Ball() { arb_set_si(x_, n); }
  Ball(const cln::cl_RA& q, long bits);
  Ball(const Ball& y) : Ball() { arb_set(x_, y.x_), bits_ = y.bits_; }
  Ball(Ball&& y) noexcept : Ball() { *this = std::move(y); }
  Ball& operator=(const Ball& y) { return arb_set(x_, y.x_), bits_ = y.bits_, *this; }
  Ball& operator=(Ball&& y) noexcept { return arb_swap(x_, y.x_), std::swap(bits_, y.bits_), *this; }
  ~Ball() { arb_clear(x_); }
  static Ball pi(long bits);
  /// Holds all numbers from low to high.
  static Ball between(const cln::cl_RA& low, const cln::cl_RA& high, long bits);

  bool is_positive() const { return arb_is_positive(x_); }
  bool is_negative() const { return arb_is_negative(x_); }
  bool is_nonzero() const { return is_positive() || is_negative(); }
  bool contains_zero() const { return arb_contains_zero(x_); }
  bool contains_integer() const { return arb_contains_int(x_); }
  bool contains(const Ball& y) const { return arb_contains(x_, y.x_); }
  bool is_exact() const { return arb_is_exact(x_); }  ///< one number, of the form m*2^n
  bool is_finite() const { return arb_is_finite(x_); }
  /// Finite, and of a size between 2^-100000 and 2^100000, or 0: its ends are numbers that one can write.
  bool is_moderate() const;
  long bits() const { return bits_; }

  /// The exact ends. Throw std::domain_error where the ball is not moderate.
  cln::cl_RA lower() const { return ends().first; }
  cln::cl_RA upper() const { return ends().second; }
  /// "0.785": so many significant digits, rounded; nothing where the ball does not make all of them certain.
  std::optional<std::string> digits(int n) const;

  /// What a function of Arb makes of it.
  Ball image(ArbFunction f) const {
    return with(bits_, [&](arb_t r) { f(r, x_, bits_); });
  }
  friend Ball operator+(const Ball& x, const Ball& y) { return combined(arb_add, x, y); }
  friend Ball operator-(const Ball& x, const Ball& y) { return combined(arb_sub, x, y); }
  friend Ball operator*(const Ball& x, const Ball& y) { return combined(arb_mul, x, y); }
  friend Ball operator/(const Ball& x, const Ball& y) { return combined(arb_div, x, y); }
  friend Ball operator-(const Ball& x) {
    return with(x.bits_, [&](arb_t r) { arb_neg(r, x.x_); });
  }
  friend Ball abs(const Ball& x) {
    return with(x.bits_, [&](arb_t r) { arb_abs(r, x.x_); });
  }
  friend Ball pow(const Ball& x, long n);

 private:
  using ArbOperation = void (*)(arb_t, const arb_t, const arb_t, slong);
  template <class Set>
  static Ball with(long bits, const Set& set) {
    Ball result;
    result.bits_ = bits;
    set(result.x_);
    return result;
  }
  static Ball combined(ArbOperation f, const Ball& x, const Ball& y) {
    const long bits = std::max(x.bits_, y.bits_);
    return with(bits, [&](arb_t r) { f(r, x.x_, y.x_, bits); });
  }
  std::pair<cln::cl_RA, cln::cl_RA> ends() const;

  arb_t x_;
  long bits_ = 64;
};

inline Ball sqrt(const Ball& x) { return x.image(arb_sqrt); }
inline Ball exp(const Ball& x) { return x.image(arb_exp); }
inline Ball log(const Ball& x) { return x.image(arb_log); }
inline Ball sin(const Ball& x) { return x.image(arb_sin); }
inline Ball cos(const Ball& x) { return x.image(arb_cos); }
inline Ball tan(const Ball& x) { return x.image(arb_tan); }
inline Ball asin(const Ball& x) { return x.image(arb_asin); }
inline Ball acos(const Ball& x) { return x.image(arb_acos); }
inline Ball atan(const Ball& x) { return x.image(arb_atan); }
inline Ball sinh(const Ball& x) { return x.image(arb_sinh); }
inline Ball cosh(const Ball& x) { return x.image(arb_cosh); }
inline Ball tanh(const Ball& x) { return x.image(arb_tanh); }
inline Ball asinh(const Ball& x) { return x.image(arb_asinh); }
inline Ball acosh(const Ball& x) { return x.image(arb_acosh); }
inline Ball atanh(const Ball& x) { return x.image(arb_atanh); }

}  // namespace rederive::inline numbers
