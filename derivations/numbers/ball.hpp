// Real numbers with a proven bound, by Arb: Johansson, "Arb: efficient arbitrary-precision midpoint-radius
// interval arithmetic", IEEE Trans. Comput. 66 (2017).
#pragma once

#include <mpfr.h>
// Arb declares its functions for MPFR only if mpfr.h is included before it.
#include <arb.h>

#include <algorithm>
#include <concepts>
#include <optional>
#include <stdexcept>
#include <string>

namespace cln {
class cl_RA;
}

namespace rederive::numbers {

/// A real number in [middle - radius, middle + radius]. A result contains every value that the operation has
/// on the operands, with the smaller of their precisions; it is not finite if a value is missing.
class Ball {
 public:
  using ArbFunction = void (*)(arb_t, const arb_t, slong);
  static constexpr long most_bits = 4096;  ///< the precision of a number that is given without one

  Ball() { arb_init(x_); }
  template <std::integral N>
  explicit Ball(N whole, long bits = most_bits) : bits_(bits) {
    arb_init(x_), arb_set_si(x_, static_cast<slong>(whole));
  }
  explicit Ball(long double number, long bits = most_bits) : Ball(0, bits) {  // exactly this number
    mpfr_t exact;
    mpfr_init2(exact, 64), mpfr_set_ld(exact, number, MPFR_RNDN);
    arf_set_mpfr(arb_midref(x_), exact), mpfr_clear(exact);
  }
  Ball(const cln::cl_RA& q, long bits);
  Ball(const Ball& y) : bits_(y.bits_) { arb_init(x_), arb_set(x_, y.x_); }
  Ball(Ball&& y) noexcept : bits_(y.bits_) { arb_init(x_), arb_swap(x_, y.x_); }
  Ball& operator=(Ball y) noexcept { return arb_swap(x_, y.x_), bits_ = y.bits_, *this; }
  ~Ball() { arb_clear(x_); }
  /// Returns a decimal number as it is written. Throws std::invalid_argument for other texts.
  static Ball parse(const std::string& text) {
    Ball result;
    if (arb_set_str(result.x_, text.c_str(), most_bits) == 0) return result;
    throw std::invalid_argument("'" + text.substr(0, 60) + "' is not a decimal number");
  }
  static Ball pi(long bits = most_bits) {
    Ball result(0, bits);
    return arb_const_pi(result.x_, bits), result;
  }
  /// Returns a ball that contains all numbers of both.
  static Ball between(const Ball& low, const Ball& high) { return of<arb_union>(low, high); }

  long bits() const { return bits_; }
  Ball at(long bits) const {
    return Ball(*this).changed([&](Ball& y) { y.bits_ = bits; });
  }

  /// Return true if the relation holds for every number in the ball; false if that is not certain.
  bool is_positive() const { return arb_is_positive(x_); }
  bool is_negative() const { return arb_is_negative(x_); }
  bool is_nonzero() const { return is_positive() || is_negative(); }
  bool is_zero() const { return arb_is_zero(x_); }
  bool contains_zero() const { return arb_contains_zero(x_); }
  bool contains_integer() const { return arb_contains_int(x_); }
  bool contains(const Ball& y) const { return arb_contains(x_, y.x_); }
  bool is_exact() const { return arb_is_exact(x_); }  ///< one number, of the form m*2^n
  bool is_finite() const { return arb_is_finite(x_); }
  /// Returns whether it is finite, and 0 or of a size from 2^-100000 to 2^100000, so that it can be written.
  bool is_moderate() const {
    constexpr long most = 100'000;
    const auto is_between = [](const auto* x, auto is_zero, auto compare, long least) {
      return is_zero(x) || (compare(x, most) < 0 && compare(x, least) > 0);
    };
    return is_finite() && is_between(arb_midref(x_), arf_is_zero, arf_cmpabs_2exp_si, -most) &&
           is_between(arb_radref(x_), mag_is_zero, mag_cmp_2exp_si, -2 * most);
  }

  /// Returns an end or the middle, exactly.
  Ball lower() const { return end(arb_get_lbound_arf); }
  Ball upper() const { return end(arb_get_ubound_arf); }
  Ball middle() const {
    return Ball(*this).changed([](Ball& y) { mag_zero(arb_radref(y.x_)); });
  }
  /// Returns the ball with a radius larger by 2^exponent.
  Ball widened(long exponent) const {
    return Ball(*this).changed([&](Ball& y) { arb_add_error_2exp_si(y.x_, exponent); });
  }
  /// Returns the middle exactly. Throws std::domain_error if the ball is not moderate.
  operator cln::cl_RA() const;
  /// Returns the double (or long double) nearest to the middle.
  double to_double() const { return arf_get_d(arb_midref(x_), ARF_RND_NEAR); }
  long double to_real() const {
    mpfr_t rounded;
    mpfr_init2(rounded, 64), arf_get_mpfr(rounded, arb_midref(x_), MPFR_RNDN);
    const long double result = mpfr_get_ld(rounded, MPFR_RNDN);
    return mpfr_clear(rounded), result;
  }
  /// Returns `count` significant digits, rounded to nearest, as %g writes them; nothing if they are not
  /// certain, that is, if the ends of the ball round to different digits.
  std::optional<std::string> digits(int count) const {
    mpfr_t low, high;
    mpfr_inits2(std::max(bits_, arb_bits(x_)), low, high, nullptr);
    arb_get_interval_mpfr(low, high, x_);
    const std::string text = written(low, count);
    const bool is_certain = is_finite() && text == written(high, count);
    mpfr_clears(low, high, nullptr);
    return is_certain ? std::optional(text) : std::nullopt;
  }

  Ball image(ArbFunction f) const {
    return Ball(0, bits_).changed([&](Ball& y) { f(y.x_, x_, bits_); });
  }
  friend Ball operator+(const Ball& x, const Ball& y) { return of<arb_add>(x, y); }
  friend Ball operator-(const Ball& x, const Ball& y) { return of<arb_sub>(x, y); }
  friend Ball operator*(const Ball& x, const Ball& y) { return of<arb_mul>(x, y); }
  friend Ball operator/(const Ball& x, const Ball& y) { return of<arb_div>(x, y); }
  friend Ball operator-(const Ball& x) { return Ball(0) - x; }
  friend Ball pow(const Ball& x, const Ball& y) { return of<arb_pow>(x, y); }
  friend Ball atan2(const Ball& y, const Ball& x) { return of<arb_atan2>(y, x); }
  friend bool operator<(const Ball& x, const Ball& y) { return arb_lt(x.x_, y.x_); }
  friend bool operator>(const Ball& x, const Ball& y) { return y < x; }

 private:
  template <auto f>
  static Ball of(const Ball& x, const Ball& y) {
    const long bits = std::min(x.bits_, y.bits_);
    return Ball(0, bits).changed([&](Ball& z) { f(z.x_, x.x_, y.x_, bits); });
  }
  template <class F>
  Ball changed(const F& change) && {
    return change(*this), std::move(*this);
  }
  Ball end(void (*bound)(arf_t, const arb_t, slong)) const {
    return Ball(0, bits_).changed([&](Ball& y) { bound(arb_midref(y.x_), x_, ARF_PREC_EXACT); });
  }
  static std::string written(const mpfr_t number, int count) {
    char* text = nullptr;
    mpfr_asprintf(&text, "%#.*Rg", count, number);
    std::string result = text;
    mpfr_free_str(text);
    const std::size_t dot = result.find('.');  // a point without a digit after it is left out
    if (dot + 1 == result.size() || result[dot + 1] == 'e') result.erase(dot, 1);
    return result;
  }

  arb_t x_;
  long bits_ = most_bits;
};

}  // namespace rederive::numbers
