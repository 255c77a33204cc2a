// A rational function of generators, read as a product whose parts a person would name: (1+w²)·sin ψ·e^{-pT}.
#pragma once

#include <derivations/algebra/phases.hpp>

#include <optional>

namespace rederive {

/// The parts of the product, each with its integer exponent, in the symbols of the statement. Nothing where a part is
/// neither a polynomial in the symbols nor a sine, cosine or exponential of one argument.
std::optional<std::vector<std::pair<GiNaC::ex, GiNaC::numeric>>> factor_form(const GiNaC::ex& fraction,
                                                                            const Phases& phases);

}  // namespace rederive
