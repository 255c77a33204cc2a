// The value of a tree at a point.
#pragma once

#include <derivations/language/syntax.hpp>
#include <derivations/numbers/value.hpp>
#include <map>
#include <memory>

namespace rederive {

/// A coordinate of a point: a real number to any precision. It keeps a value: its copies stay in one thread.
class Number {
 public:
  Number(const cln::cl_RA& q) : state_(new State{nullptr, {}, q}) {}
  /// The value of a constant expression: pi/6, sqrt(2).
  explicit Number(const Tree& constant) : state_(new State{constant}) {}
  /// The zero of an expression in one symbol, between two rational numbers where it has different signs, is
  /// continuous and has one zero; unknown where its signs there are not certain.
  Number(const Tree& tree, const std::string& symbol, const cln::cl_RA& low, const cln::cl_RA& high)
      : state_(new State{tree, symbol, low, high, low, high}) {}
  /// Its value; the ball of a zero has about so many bits that are right.
  const Value& value(long bits) const;

  struct State {
    Tree tree;                                       ///< nullptr of a rational number
    std::string symbol = {};                         ///< empty of a constant
    cln::cl_RA low = 0, high = 0, from = 0, to = 0;  ///< the bracket; what is left of it
    long bits = 0;                                   ///< of the value
    Value value = {};
  };
  const State& operator*() const { return *state_; }

 private:
  std::shared_ptr<State> state_;
};

/// Symbol name → its value. Whatever takes one throws std::out_of_range for a symbol that it does not give.
using Point = std::map<std::string, Number>;

/// The real value of a tree, computed with so many bits.
Value value_at(const Tree& tree, const Point& point, long bits);

enum class Sign { negative, zero, positive, undefined, unknown };
/// The sign of left - right, at 192, 576, … bits up to `most`: zero is exact; `undefined` where one of
/// the two certainly has no value, `unknown` where no precision told.
Sign sign_at(const Tree& left, const Tree& right, const Point& point, long most = 2000);

/// So many significant digits of a tree, rounded; fewer where a rational value has no more: "0", "0.25".
/// Nothing where it has no value, or where 9 times the bits do not make them certain.
std::optional<std::string> digits_at(const Tree& tree, const Point& point, int digits);

}  // namespace rederive
