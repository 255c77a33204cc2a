// Derivatives and integrals that a paper prints, worked out.
#pragma once

#include <derivations/mechanics/time_derivative.hpp>

namespace rederive::paper {

/// Returns the rates that the names of symbols declare: theta, thetadot, thetaddot; u_g, u_gdot or udot_g.
/// The time t has the rate 1.
mechanics::Rates rates_in(const language::Symbols& symbols);

/// Returns df/dt by the declared rates; a symbol without a rate is constant in time. Throws
/// std::invalid_argument if f contains a rate whose own rate is not declared.
GiNaC::ex total_derivative(const GiNaC::ex& f, const language::Symbols& symbols);

/// Returns the integral of f over x from one limit to the other. The integrand is a sum of products of powers
/// of x, and of exp, sin, cos, sinh and cosh of what is linear in x; or a power of what is linear in x. Where
/// the power has a pole, the limits must be seen to be positive. Throws std::invalid_argument, with the term,
/// for other integrands.
GiNaC::ex definite_integral(const GiNaC::ex& f, const language::SymbolExpression& x, const GiNaC::ex& from,
                            const GiNaC::ex& to);

}  // namespace rederive::paper
