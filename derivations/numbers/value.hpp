// The value of an expression: exactly a + b*pi, or a ball, or nothing.
#pragma once

#include <cln/integer.h>
#include <cln/rational.h>

#include <derivations/language/symbols.hpp>
#include <derivations/numbers/ball.hpp>
#include <utility>

namespace rederive::numbers {

/// An integer of FLINT that frees its memory.
struct Integer {
  Integer() { fmpz_init(z); }
  explicit Integer(const cln::cl_I& value) : Integer() {
    if (const auto length = cln::integer_length(value); length < 8 * static_cast<long>(sizeof(long)) - 4) {
      fmpz_set_si(z, cln::cl_I_to_long(value));
    } else {
      const Integer high(cln::ash(value, -static_cast<long>(length / 2)));
      fmpz_mul_2exp(z, high.z, length / 2);
      fmpz_add(z, z, Integer(cln::ldb(value, cln::cl_byte(length / 2, 0))).z);
    }
  }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  ~Integer() { fmpz_clear(z); }
  cln::cl_I value() const {
    if (fmpz_fits_si(z)) return cln::cl_I(fmpz_get_si(z));
    const auto half = fmpz_bits(z) / 2;
    Integer high, low;
    fmpz_fdiv_q_2exp(high.z, z, half), fmpz_fdiv_r_2exp(low.z, z, half);
    return cln::ash(high.value(), static_cast<long>(half)) + low.value();
  }
  fmpz_t z;
};

/// The number a + b*pi with rational a and b. Only 0 + 0*pi is 0, for pi is irrational (Lambert 1768).
struct Constant {
  cln::cl_RA a = 0, b = 0;

  bool is_rational() const { return cln::zerop(b); }
  bool is_zero() const { return cln::zerop(a) && cln::zerop(b); }
  Ball ball(long bits) const;
  int sign() const;
  friend Constant operator+(const Constant& x, const Constant& y) { return {x.a + y.a, x.b + y.b}; }
  friend Constant operator-(const Constant& x, const Constant& y) { return {x.a - y.a, x.b - y.b}; }
  friend Constant operator*(const cln::cl_RA& q, const Constant& x) { return {q * x.a, q * x.b}; }
};

/// The value of an expression with given values of its symbols.
struct Value {
  enum class Is {
    certain,  ///< it has a value
    nowhere,  ///< it certainly has no real value: 1/0, sqrt(-1), log(0)
    unknown   ///< the precision does not decide it
  };
  Is is = Is::unknown;
  std::optional<cln::cl_RA> exact = {};   ///< if it was found by rational arithmetic alone
  std::optional<Constant> constant = {};  ///< if it is known to be a + b*pi
  mutable Ball enclosure = {};
  mutable bool is_late = false;  ///< the enclosure of a constant is computed when it is needed

  /// Returns a ball that contains the value. `is` must be certain.
  const Ball& ball() const {
    if (std::exchange(is_late, false)) enclosure = constant->ball(enclosure.bits());
    return enclosure;
  }
  /// Returns -1, 0 (exactly) or +1; nothing if that is not certain.
  std::optional<int> sign() const;
};

// The operations are exact while values are a + b*pi of moderate length; then they give balls.
Value known(const Constant& c, long bits);
Value known(const Ball& x);  ///< exact if the ball is; unknown if it is not moderate
Value operator+(const Value& x, const Value& y);
Value operator-(const Value& x, const Value& y);
Value operator*(const Value& x, const Value& y);
Value operator/(const Value& x, const Value& y);
/// Returns the real power: x^n for whole n, x^y for other y and x > 0, 0^y = 0 for y > 0. 0^0 has no value.
Value pow(const Value& x, const Value& y);
/// Returns the value of a function of our syntax. Throws std::out_of_range for an unknown function.
Value call(const std::string& function, const Value& x);

}  // namespace rederive::numbers
