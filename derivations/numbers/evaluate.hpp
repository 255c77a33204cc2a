// The value of a tree at a point.
#pragma once

#include <derivations/language/syntax.hpp>
#include <derivations/numbers/value.hpp>
#include <map>
#include <memory>

namespace rederive::numbers {

/// A coordinate of a point, a real number to any precision. Copies share a value: use them in one thread.
class Number {
 public:
  Number(const cln::cl_RA& q) : state_(new State{nullptr, {}, q}) {}
  /// The value of a constant expression: pi/6, sqrt(2).
  explicit Number(const language::Tree& constant) : state_(new State{constant}) {}
  /// The zero of an expression in one symbol between two rational numbers. There the expression must be
  /// continuous and have one zero and different signs; if the signs are not certain, the value is unknown.
  Number(const language::Tree& tree, const std::string& symbol, const cln::cl_RA& low, const cln::cl_RA& high)
      : state_(new State{tree, symbol, low, high, low, high}) {}
  /// Returns its value; the ball of a zero has about `bits` correct bits.
  const Value& value(long bits) const;

  struct State {
    language::Tree tree;                             ///< nullptr for a rational number
    std::string symbol = {};                         ///< empty for a constant
    cln::cl_RA low = 0, high = 0, from = 0, to = 0;  ///< the bracket, and its present part
    long bits = 0;                                   ///< of the value
    Value value = {};
  };
  const State& operator*() const { return *state_; }

 private:
  std::shared_ptr<State> state_;
};

/// Symbol name → value. A function that takes a Point throws std::out_of_range for a symbol that it lacks.
using Point = std::map<std::string, Number>;

/// Returns the real value of a tree at a point, computed with `bits` bits.
Value value_at(const language::Tree& tree, const Point& point, long bits);

enum class Sign { negative, zero, positive, undefined, unknown };
/// Returns the sign of left - right, tried with 192, 576, … bits up to `most`. `zero` is exact; `undefined`
/// means that a side certainly has no value, `unknown` that no precision decided it.
Sign sign_at(const language::Tree& left, const language::Tree& right, const Point& point, long most = 2000);

/// Returns `digits` significant digits of a tree, rounded, or fewer if a rational value has no more ("0.25").
/// Returns nothing if it has no value, or if 9 times the bits do not make the digits certain.
std::optional<std::string> digits_at(const language::Tree& tree, const Point& point, int digits);

}  // namespace rederive::numbers
