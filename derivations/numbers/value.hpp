// What an expression is worth: exactly a + b*pi, or a ball, or nothing.
#pragma once

#include <cln/rational.h>

#include <derivations/language/symbols.hpp>
#include <derivations/numbers/ball.hpp>
#include <utility>

namespace rederive {

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

/// The value of an expression where its symbols are given.
struct Value {
  enum class Is {
    certain,  ///< it has a value
    nowhere,  ///< it certainly has no real value: 1/0, sqrt(-1), log(0)
    unknown   ///< these bits do not tell
  };
  Is is = Is::unknown;
  std::optional<cln::cl_RA> exact = {};   ///< where only rational arithmetic led to it
  std::optional<Constant> constant = {};  ///< where it is known to be a + b*pi
  mutable Ball enclosure = {};
  mutable bool is_late = false;  ///< the enclosure of a constant: computed when it is first asked for

  /// Where it is certain.
  const Ball& ball() const {
    if (std::exchange(is_late, false)) enclosure = constant->ball(enclosure.bits());
    return enclosure;
  }
  /// -1, 0 (exactly), +1, where that is certain.
  std::optional<int> sign() const;
};

// They are exact as long as values are a + b*pi of moderate length; then come balls.
Value known(const Constant& c, long bits);
Value known(const Ball& x);  ///< exact where the ball is; unknown where it is not moderate
Value operator+(const Value& x, const Value& y);
Value operator-(const Value& x, const Value& y);
Value operator*(const Value& x, const Value& y);
Value operator/(const Value& x, const Value& y);
/// As a real function: x^n for each whole n, x^y for other y and x > 0, 0^y = 0 for y > 0; 0^0 has no value.
Value pow(const Value& x, const Value& y);
/// A function of our syntax by its name. Throws std::out_of_range for an unknown one.
Value call(const std::string& function, const Value& x);

/// "cos" of "sec"; nullptr where a function is not defined as 1/f.
const char* reciprocal_of(const std::string& name);

}  // namespace rederive
