// Lets a function stand alone on one side of a relation: 2 log x + 1 < y becomes log x < (y-1)/2.
#pragma once

#include <derivations/algebra/unwrap.hpp>

namespace rederive {

/// Whether a symbol is in it: constants are not solved for.
bool has_symbol(const GiNaC::ex& expression);

/// The relation inside of a layer "*": its two sides, and the operator turned where the factor is negative.
Sides rearranged(const Layer& layer, const std::string& op, const Symbols& symbols);

/// The ways to write left - right as factor·(function - rest) with a factor that is never 0, and of known sign
/// where the relation is an inequality: for logarithms of positive arguments with commensurable factors as
/// one, and for each function in which left - right is linear. Inverse functions first, then roots and
/// absolute values, then all others; their texts decide among equals, so that the order is always the same.
std::vector<Layer> rearrangements(const Sides& sides, const Symbols& symbols);

}  // namespace rederive
