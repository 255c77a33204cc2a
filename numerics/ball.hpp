// Real numbers known to lie in a ball: Arb (F. Johansson, IEEE Trans. Computers 66, 2017) as a value type.
#pragma once

#include <mpfr.h>
// Arb declares what uses MPFR only where that stands before it.
#include <arb.h>

#include <algorithm>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace rederive {
inline namespace proven {

/// A real number in [middle - radius, middle + radius]. Every operation gives a ball that holds the result
/// for all numbers in its operands; it rounds to the larger of their bits, and enlarges the radius by the
/// rounding. Functions are found by argument-dependent lookup, so that a formula written for any number type
/// is proven.
class Ball {
 public:
  static constexpr long most_bits = 4096;

  Ball() : Ball(0) {}
  template <std::integral N>
  explicit Ball(N whole) {
    arb_init(value_);
    arb_set_si(value_, static_cast<slong>(whole));
  }
  /// Exactly that number, with which is reckoned in so many bits.
  explicit Ball(long double number, long bits = most_bits) : bits_(bits) {
    arb_init(value_);
    mpfr_t exact;
    mpfr_init2(exact, 64);
    mpfr_set_ld(exact, number, MPFR_RNDN);
    arf_set_mpfr(arb_midref(value_), exact);
    mpfr_clear(exact);
  }
  /// A decimal number as it is written. Throws std::invalid_argument.
  static Ball parse(const std::string& text) {
    Ball result;
    if (arb_set_str(result.value_, text.c_str(), most_bits) != 0)
      throw std::invalid_argument("'" + text.substr(0, 60) + "' is not a decimal number");
    return result;
  }
  static Ball pi() {
    Ball result;
    arb_const_pi(result.value_, most_bits);
    return result;
  }
  /// The same, with which is reckoned in so many bits.
  Ball at(long bits) const {
    Ball result = *this;
    result.bits_ = bits;
    return result;
  }

  Ball(const Ball& other) : bits_(other.bits_) {
    arb_init(value_);
    arb_set(value_, other.value_);
  }
  Ball(Ball&& other) noexcept : bits_(other.bits_) {
    arb_init(value_);
    arb_swap(value_, other.value_);
  }
  Ball& operator=(Ball other) noexcept {
    arb_swap(value_, other.value_);
    bits_ = other.bits_;
    return *this;
  }
  ~Ball() { arb_clear(value_); }

  long bits() const { return bits_; }

  /// Of every number in the ball. What is not certain is false.
  bool is_positive() const { return arb_is_positive(value_); }
  bool is_negative() const { return arb_is_negative(value_); }
  bool is_zero() const { return arb_is_zero(value_); }
  bool contains_zero() const { return arb_contains_zero(value_); }

  /// The ends and the middle, exact.
  Ball lower() const { return end<arb_get_lbound_arf>(); }
  Ball upper() const { return end<arb_get_ubound_arf>(); }
  Ball middle() const {
    Ball result = *this;
    mag_zero(arb_radref(result.value_));
    return result;
  }
  /// The ball with a radius larger by 2^exponent.
  Ball widened(long exponent) const {
    Ball result = *this;
    arb_add_error_2exp_si(result.value_, exponent);
    return result;
  }
  /// The nearest to the middle.
  double to_double() const { return arf_get_d(arb_midref(value_), ARF_RND_NEAR); }
  long double to_real() const {
    mpfr_t rounded;
    mpfr_init2(rounded, 64);
    arf_get_mpfr(rounded, arb_midref(value_), MPFR_RNDN);
    const long double result = mpfr_get_ld(rounded, MPFR_RNDN);
    mpfr_clear(rounded);
    return result;
  }
  /// `count` significant digits, rounded to nearest, as %g writes them; nothing if not all of them are
  /// certain: both ends of the ball must round to the same.
  std::optional<std::string> digits(int count) const {
    mpfr_t low, high;
    mpfr_inits2(bits_, low, high, nullptr);
    arb_get_interval_mpfr(low, high, value_);
    const std::string text = written(low, count);
    const bool certain = text == written(high, count);
    mpfr_clears(low, high, nullptr);
    return certain ? std::optional(text) : std::nullopt;
  }

  friend Ball operator+(const Ball& a, const Ball& b) { return of<arb_add>(a, b); }
  friend Ball operator-(const Ball& a, const Ball& b) { return of<arb_sub>(a, b); }
  friend Ball operator*(const Ball& a, const Ball& b) { return of<arb_mul>(a, b); }
  friend Ball operator/(const Ball& a, const Ball& b) { return of<arb_div>(a, b); }
  friend Ball operator-(const Ball& a) { return Ball(0) - a; }
  friend bool operator<(const Ball& a, const Ball& b) { return arb_lt(a.value_, b.value_); }
  friend bool operator>(const Ball& a, const Ball& b) { return b < a; }

  friend Ball sin(const Ball& x) { return of<arb_sin>(x); }
  friend Ball cos(const Ball& x) { return of<arb_cos>(x); }
  friend Ball tan(const Ball& x) { return of<arb_tan>(x); }
  friend Ball exp(const Ball& x) { return of<arb_exp>(x); }
  friend Ball log(const Ball& x) { return of<arb_log>(x); }
  friend Ball sinh(const Ball& x) { return of<arb_sinh>(x); }
  friend Ball cosh(const Ball& x) { return of<arb_cosh>(x); }
  friend Ball tanh(const Ball& x) { return of<arb_tanh>(x); }
  friend Ball sqrt(const Ball& x) { return of<arb_sqrt>(x); }
  friend Ball atan2(const Ball& y, const Ball& x) { return of<arb_atan2>(y, x); }

 private:
  template <auto function>
  static Ball of(const Ball& a) {
    Ball result = Ball().at(a.bits_);
    function(result.value_, a.value_, a.bits_);
    return result;
  }
  template <auto function>
  static Ball of(const Ball& a, const Ball& b) {
    Ball result = Ball().at(std::min(a.bits_, b.bits_));
    function(result.value_, a.value_, b.value_, result.bits_);
    return result;
  }
  template <auto bound>
  Ball end() const {
    Ball result = middle();
    bound(arb_midref(result.value_), value_, ARF_PREC_EXACT);
    return result;
  }
  static std::string written(const mpfr_t number, int count) {
    char* text = nullptr;
    mpfr_asprintf(&text, "%#.*Rg", count, number);
    std::string result = text;
    mpfr_free_str(text);
    const std::size_t dot = result.find('.');  // not left without a digit behind it
    if (dot + 1 == result.size() || result[dot + 1] == 'e') result.erase(dot, 1);
    return result;
  }

  arb_t value_;
  long bits_ = most_bits;
};

}  // namespace proven
}  // namespace rederive
