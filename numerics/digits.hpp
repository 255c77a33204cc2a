// A number with as many digits as wanted, for the emitted formulas: a thin coat over CLN's cl_F.
#pragma once

#include <cln/float.h>
#include <cln/float_io.h>
#include <cln/integer.h>
#include <cln/real.h>

#include <concepts>
#include <string>
#include <string_view>

namespace rederive::inline numeric {

/// Behaves as a floating-point type; functions are found by argument-dependent lookup. All numbers carry
/// `working_digits` decimal digits, which is a property of the type.
class Digits {
 public:
  static constexpr int working_digits = 340;  ///< a pulse of omega_p/p = 0.01 magnifies by e^628

  Digits() : Digits(0) {}
  template <std::integral N>
  Digits(N whole) : value_(cln::cl_float(cln::cl_I(static_cast<long>(whole)), format())) {}
  template <std::floating_point F>
  explicit Digits(F value) : Digits(sum(static_cast<double>(value), value - static_cast<double>(value))) {}
  explicit Digits(const cln::cl_F& value) : value_(value) {}

  /// Reads a decimal number exactly as it is written. Throws std::invalid_argument.
  static Digits parse(std::string_view text);
  static Digits pi() { return Digits(cln::pi(format())); }

  /// The value rounded to `count` significant digits, as text.
  std::string text(int count) const;
  double to_double() const;
  /// To the nearest long double but one; infinite or zero where it has no such power of two.
  long double to_real() const;
  const cln::cl_F& value() const { return value_; }

  Digits& operator+=(const Digits& b) {
    value_ = value_ + b.value_;
    return *this;
  }
  Digits& operator-=(const Digits& b) {
    value_ = value_ - b.value_;
    return *this;
  }
  Digits& operator*=(const Digits& b) {
    value_ = value_ * b.value_;
    return *this;
  }
  Digits& operator/=(const Digits& b) {
    value_ = value_ / b.value_;
    return *this;
  }
  friend Digits operator+(Digits a, const Digits& b) { return a += b; }
  friend Digits operator-(Digits a, const Digits& b) { return a -= b; }
  friend Digits operator*(Digits a, const Digits& b) { return a *= b; }
  friend Digits operator/(Digits a, const Digits& b) { return a /= b; }
  friend Digits operator-(const Digits& a) { return Digits(-a.value_); }
  friend Digits operator+(const Digits& a) { return a; }
  friend bool operator<(const Digits& a, const Digits& b) { return a.value_ < b.value_; }
  friend bool operator>(const Digits& a, const Digits& b) { return b < a; }
  friend bool operator==(const Digits& a, const Digits& b) { return a.value_ == b.value_; }

  friend Digits sin(const Digits& x) { return Digits(cln::sin(x.value_)); }
  friend Digits cos(const Digits& x) { return Digits(cln::cos(x.value_)); }
  friend Digits tan(const Digits& x) { return Digits(cln::tan(x.value_)); }
  friend Digits exp(const Digits& x) { return Digits(cln::exp(x.value_)); }
  friend Digits sinh(const Digits& x) { return Digits(cln::sinh(x.value_)); }
  friend Digits cosh(const Digits& x) { return Digits(cln::cosh(x.value_)); }
  friend Digits tanh(const Digits& x) { return Digits(cln::tanh(x.value_)); }
  friend Digits sqrt(const Digits& x) { return Digits(cln::sqrt(x.value_)); }
  friend Digits abs(const Digits& x) { return Digits(cln::abs(x.value_)); }
  friend Digits atan2(const Digits& y, const Digits& x);

 private:
  static cln::float_format_t format() { return cln::float_format(working_digits); }
  template <std::floating_point F>
  static cln::cl_F sum(double high, F low) {  // CLN knows no long double
    return cln::cl_float(cln::cl_F(high), format()) +
           cln::cl_float(cln::cl_F(static_cast<double>(low)), format());
  }
  cln::cl_F value_;
};

}  // namespace rederive::numeric
