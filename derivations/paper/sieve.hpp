// Sifts many candidates for the right answer, in doubles. What passes must still be proved.
#pragma once

#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rederive::paper {

using RoughPoint = std::map<std::string, double, std::less<>>;

/// Returns the value of a tree; NaN if it has none, or if a symbol is missing in `at`.
double rough_value(const language::Tree& tree, const RoughPoint& at);
/// Returns a number as a small fraction, of 1, π, π/180 or 180/π; nothing if it is not one.
std::optional<language::Tree> plain_number(double value);
/// Returns whether a value is inside the range of a symbol.
bool lies_in(const language::Symbol& symbol, double value);
/// Returns whether relations of two sides hold at a point, inequalities strictly.
bool holds(const std::vector<language::Relation>& relations, const RoughPoint& at);

/// A few points inside the ranges of the symbols, at which `assumed` holds, each with the value of the right
/// expression; or points at which the right equation holds. The symbols of `given` have their values there.
class Sieve {
 public:
  Sieve(const language::Relation& right, const std::vector<language::Given>& given, const std::string& pivot,
        const language::Symbols& symbols, const std::vector<language::Relation>& assumed);
  bool is_empty() const { return points_.empty(); }
  /// Returns whether a candidate agrees with the right answer at all points, to nine digits.
  bool passes(const language::Relation& candidate) const;
  /// Returns whether a candidate has a value at one of the points at least.
  bool has_value(const language::Relation& candidate) const;
  /// Returns the number for the symbol `unknown` with which it does, if the answer is linear in that symbol.
  std::optional<double> solved(const language::Relation& candidate) const;
  static constexpr const char* unknown = "?";

 private:
  struct Sample {
    RoughPoint at;
    double right = 0;
  };
  std::vector<Sample> points_;
};

}  // namespace rederive::paper
