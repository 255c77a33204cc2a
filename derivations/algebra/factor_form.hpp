// A rational function of generators, read as a product whose parts a person would name: (1+w²)·sin ψ·e^{-pT}.
#pragma once

#include <derivations/algebra/phases.hpp>
#include <optional>
#include <utility>
#include <vector>

namespace rederive {

/// A part of a product in the symbols of the statement, with its exponent.
using Part = std::pair<GiNaC::ex, GiNaC::numeric>;

/// The parts of the product, each with its integer exponent. Every part is real: c + Σ a cos(…) + Σ b sin(…),
/// with polynomials, cosh, sinh and exp. Nothing where the fraction is not real, factor by factor.
std::optional<std::vector<Part>> factor_form(const GiNaC::ex& fraction, const Phases& phases);

/// The same of an expression that has been prepared: its generators are made here.
std::optional<std::vector<Part>> factor_form(const GiNaC::ex& prepared, const Symbols& symbols);

/// Whether no factor of it can become negative: where it has a logarithm, it is positive.
bool is_positive_where_defined(const GiNaC::ex& prepared, const Symbols& symbols);

}  // namespace rederive
