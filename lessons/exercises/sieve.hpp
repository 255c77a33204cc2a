// Sifts many candidates for the right answer, in plain doubles: what passes is still to be proved.
#pragma once

#include <lessons/exercises/exercise.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rederive::classroom {

using RoughPoint = std::map<std::string, double, std::less<>>;

/// The value of a tree in doubles; not a number where it has none, or where a symbol is not given.
double rough_value(const Tree& tree, const RoughPoint& at);
/// Whether a value lies inside the range of a symbol.
bool lies_in(const Symbol& symbol, double value);
/// Whether relations of two sides hold there; an inequality, strictly.
bool holds(const std::vector<Relation>& relations, const RoughPoint& at);

/// A few points inside the ranges of the symbols, where what is assumed holds: with what the right expression
/// is worth there, or such that the right equation holds there. The symbols of `given` have the values that
/// they stand for.
class Sieve {
 public:
  Sieve(const Relation& right, const std::vector<Given>& given, const std::string& pivot,
        const Symbols& symbols, const std::vector<Relation>& assumed);
  bool is_empty() const { return points_.empty(); }
  /// Whether a candidate agrees with the right answer at all points, to nine digits.
  bool passes(const Relation& candidate) const;
  /// The number for the symbol `unknown` with which it does, where the answer is linear in it.
  std::optional<double> solved(const Relation& candidate) const;
  static constexpr const char* unknown = "?";

 private:
  struct Sample {
    RoughPoint at;
    double right = 0;
  };
  std::vector<Sample> points_;
};

}  // namespace rederive::classroom
