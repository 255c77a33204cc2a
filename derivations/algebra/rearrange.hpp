// Lets a function stand alone on one side of a relation: 2 log x + 1 < y becomes log x < (y-1)/2.
#pragma once

#include <derivations/algebra/unwrap.hpp>
#include <optional>

namespace rederive {

/// Whether a symbol is in it: constants are not solved for.
bool has_symbol(const GiNaC::ex& expression);

/// One fraction in lowest terms, as far as GiNaC can say; long ones stay as they are.
GiNaC::ex simplified(const GiNaC::ex& expression);

/// With exp(x + y) for exp(x)*exp(y).
GiNaC::ex with_exponents_together(const GiNaC::ex& expression);

/// Which functions go first. 0: inverse functions, which are always taken off; 1: roots and absolute values,
/// where the other side is not negative; 2: where the other side is a constant or the same function.
std::optional<int> rank_of(const GiNaC::ex& expression);

/// The relation inside of a layer "*": its two sides, and the operator turned where the factor is negative.
Sides rearranged(const Layer& layer, const std::string& op);

/// The ranges narrowed to where the relation has a value at all: x > 0 beside log(x), x >= 0 beside sqrt(x).
Symbols narrowed_by_functions(const Sides& sides, Symbols symbols);

/// The ways to write left - right as factor·(function - rest) with a factor that is never 0, and of known
/// sign where the relation is an inequality: for logarithms of positive arguments with commensurable factors
/// as one, and for each function in which left - right is linear. In the order of their ranks; texts decide
/// among equals, so that it is always the same.
std::vector<Layer> rearrangements(const Sides& sides, const Symbols& symbols);

/// Two sides that are n-th powers, as 32*x^5 and y^10 are those of 2*x and y^2, for the largest n, above 2:
/// the layer "^n".
std::optional<Layer> common_power(const Sides& sides);

/// a < b is a² < b² where neither side is negative, and -a > -b where neither is positive: the roots of the
/// squares are the sides. The layers are appended. Nothing where a + b is never 0 (then it is a factor that
/// shows as much), where no sign is known, or where the squares would be long.
std::optional<Sides> squared(const Sides& sides, const Symbols& symbols,
                             std::vector<Layer>* layers = nullptr);

/// left - right as a product of which only one part may have either sign: that part, and 0; sums of powers
/// of sines and cosines are sums of sines and cosines of multiples there.
std::optional<Layer> factored(const Sides& sides, const Symbols& symbols);

}  // namespace rederive
