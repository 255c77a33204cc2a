// The linear equation m q̈ + c q̇ + k q = f(t) with constant coefficients: linearisation, and its solution by
// undetermined coefficients, from initial or boundary values.
#pragma once

#include <derivations/mechanics/solve.hpp>

namespace rederive::mechanics {

/// Returns the Taylor polynomial of f in the symbols `small`, which have the same order of magnitude, to
/// total degree `order` >= 0. Throws GiNaC's error for a pole at 0.
GiNaC::ex taylor(const GiNaC::ex& f, const std::vector<language::SymbolExpression>& small, int order);

/// The roots of m λ² + c λ + k: the motion is underdamped, critically damped or overdamped, if it is damped.
enum class Roots { complex, equal, real };

/// The equation mass·q̈ + damping·q̇ + stiffness·q = forcing. The coefficients are constants of either sign; it
/// is of first order if the mass is 0. The forcing is a sum of products of a constant, powers of the time,
/// exponentials and hyperbolic functions, and at most one sine or cosine, with phases linear in time.
struct LinearEquation {
  GiNaC::ex mass, damping, stiffness;
  GiNaC::ex forcing;
  language::SymbolExpression time;
  Relations known = {};             ///< decides between the three cases of `Roots`: zeta < 1
  std::optional<Roots> roots = {};  ///< the choice of the caller; becomes a condition
  language::SymbolExpression quantity = language::SymbolExpression(GiNaC::realsymbol("q"));  ///< in steps
};

/// Returns which roots the equation of second order has. Throws std::invalid_argument if neither the signs of
/// symbols nor `known` decide it and the caller has not chosen, or if the choice is wrong.
Roots roots_of(const LinearEquation& equation);

/// The constants of general_solution.
struct Constants {
  GiNaC::ex C, D;
};

/// A solution with its argument.
struct Motion {
  GiNaC::ex value;
  std::vector<Step> steps;
  std::vector<Step> conditions;  ///< without which it may have no value: relations with 0
  Constants constants;
};

/// Returns one solution. A family of functions is multiplied by the time once or twice at resonance; where
/// resonance is not excluded, its absence is a condition. Throws std::invalid_argument for another forcing.
Motion particular_solution(const LinearEquation& equation);

/// Returns e^{−c τ/(2 m)} (C s(τ) + D c(τ)) + particular_solution with τ = t − start, where s and c are sin
/// and cos of the damped frequency times τ, or sinh and cosh, or τ and 1; for an equation of first order, C
/// e^{−k τ/c} + particular_solution. Throws as particular_solution and roots_of do.
Motion general_solution(const LinearEquation& equation, const GiNaC::ex& start, const GiNaC::ex& C,
                        const GiNaC::ex& D);

/// A value of the solution, or of its first derivative, at some time.
struct Condition {
  GiNaC::ex time, value;
  int derivative = 0;
};
/// Returns the conditions q(start) = position and q̇(start) = rate.
std::vector<Condition> from_start(const GiNaC::ex& start, const GiNaC::ex& position, const GiNaC::ex& rate);

/// Returns the solution that satisfies initial or boundary conditions: two, or one for an equation of first
/// order. τ counts from the time of the first one. Throws std::invalid_argument for another number of
/// conditions, and as general_solution and solve do.
Motion solution(const LinearEquation& equation, const std::vector<Condition>& conditions);

}  // namespace rederive::mechanics
