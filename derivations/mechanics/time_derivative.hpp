// Time derivatives along a motion that is not solved yet: θ, θ̇, θ̈ … are independent symbols.
#pragma once

#include <derivations/mechanics/derivation.hpp>
#include <utility>
#include <vector>

namespace rederive::mechanics {

/// Pairs of a symbol and its rate: {θ, θ̇}, {θ̇, θ̈}, {u_g, u̇_g} …, and {t, 1} if the time itself appears.
using Rates = std::vector<std::pair<language::SymbolExpression, GiNaC::ex>>;

/// Returns df/dt = Σ ∂f/∂q · q̇ over the pairs of `rates`. A symbol without a pair is constant in time.
GiNaC::ex time_derivative(const GiNaC::ex& f, const Rates& rates);

/// A coordinate with its first and second time derivatives.
struct Coordinate {
  language::SymbolExpression position, rate, second_rate;
};

/// Lagrange's equation d/dt(∂K/∂q̇) − ∂K/∂q + ∂Ω/∂q + ∂D/∂q̇ = Q, term by term.
struct LagrangeTerms {
  GiNaC::ex momentum;           ///< ∂K/∂q̇
  GiNaC::ex momentum_rate;      ///< d/dt(∂K/∂q̇)
  GiNaC::ex kinetic_slope;      ///< ∂K/∂q
  GiNaC::ex potential_slope;    ///< ∂Ω/∂q
  GiNaC::ex dissipation_slope;  ///< ∂D/∂q̇
  GiNaC::ex force;              ///< Q
  std::vector<Step> steps;
  /// Returns the left side less the right side, which is 0 in every motion.
  GiNaC::ex sum() const {
    return momentum_rate - kinetic_slope + potential_slope + dissipation_slope - force;
  }
};
/// Returns the terms for a coordinate, with Rayleigh's function `dissipation`, half the power that is lost,
/// and a generalised force. Throws std::invalid_argument if the potential depends on the rate.
LagrangeTerms lagrange_terms(const GiNaC::ex& kinetic, const GiNaC::ex& potential,
                             const Coordinate& coordinate, const Rates& rates,
                             const GiNaC::ex& dissipation = 0, const GiNaC::ex& force = 0);

}  // namespace rederive::mechanics
