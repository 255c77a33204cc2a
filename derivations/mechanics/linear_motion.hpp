// The linear equation of motion θ̈ − k²θ = f(t): linearisation, and its solution by undetermined coefficients.
#pragma once

#include <derivations/language/symbols.hpp>
#include <vector>

namespace rederive::mechanics {

/// Returns the Taylor polynomial of f in the symbols `small`, which have the same order of magnitude, to
/// total degree `order` >= 0. Throws GiNaC's error for a pole at 0.
GiNaC::ex taylor(const GiNaC::ex& f, const std::vector<language::SymbolExpression>& small, int order);

/// The equation θ̈ − k²θ = forcing with a constant k. The forcing is a sum of constants, multiples of the
/// time, and sines and cosines of phases that are linear in time.
struct LinearEquation {
  GiNaC::ex k;
  GiNaC::ex forcing;
  language::SymbolExpression time;
};

/// Returns one solution, by the ansatz Σ Cⱼ φⱼ(t). The φⱼ are a constant, the time if the forcing contains
/// it, and the functions in the forcing and its derivatives. Throws std::invalid_argument if a few
/// derivatives do not close the set.
GiNaC::ex particular_solution(const LinearEquation& equation);

/// Returns C sinh k(t − start) + D cosh k(t − start) + particular_solution. Throws as particular_solution
/// does.
GiNaC::ex general_solution(const LinearEquation& equation, const GiNaC::ex& start, const GiNaC::ex& C,
                           const GiNaC::ex& D);

/// The constants of general_solution.
struct Constants {
  GiNaC::ex C, D;
};
Constants constants_from_start(const LinearEquation& equation, const GiNaC::ex& start, const GiNaC::ex& angle,
                               const GiNaC::ex& rate);

/// Returns the solution with θ(start) = angle and θ̇(start) = rate. Throws as particular_solution does.
GiNaC::ex solution_from(const LinearEquation& equation, const GiNaC::ex& start, const GiNaC::ex& angle,
                        const GiNaC::ex& rate);

}  // namespace rederive::mechanics
