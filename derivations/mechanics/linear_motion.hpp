// θ̈ − k²θ = f(t): linearisation that leads to it, and its solution by undetermined coefficients.
#pragma once

#include <derivations/language/symbols.hpp>
#include <vector>

namespace rederive {

/// The Taylor polynomial of f in the symbols `small`, all of one order of magnitude, to total degree `order`
/// >= 0. A pole at 0 throws what GiNaC throws at it.
GiNaC::ex taylor(const GiNaC::ex& f, const std::vector<SymbolExpression>& small, int order);

/// θ̈ − k²θ = forcing, with a constant k; the forcing is a sum of constants, multiples of the time, and sines
/// and cosines of phases linear in time.
struct LinearEquation {
  GiNaC::ex k;
  GiNaC::ex forcing;
  SymbolExpression time;
};

/// One solution, from the ansatz Σ Cⱼ φⱼ(t) over the constant, the time if the forcing has it, and the
/// functions φⱼ that the forcing and its derivatives consist of. Throws std::invalid_argument if they do not
/// close after a few derivatives.
GiNaC::ex particular_solution(const LinearEquation& equation);

/// C sinh k(t − start) + D cosh k(t − start) + particular_solution. This and what follows throw as that does.
GiNaC::ex general_solution(const LinearEquation& equation, const GiNaC::ex& start, const GiNaC::ex& C,
                           const GiNaC::ex& D);

/// The constants of general_solution from θ(start) and θ̇(start).
struct Constants {
  GiNaC::ex C, D;
};
Constants constants_from_start(const LinearEquation& equation, const GiNaC::ex& start, const GiNaC::ex& angle,
                               const GiNaC::ex& rate);

/// The solution that leaves θ(start) = angle with θ̇(start) = rate.
GiNaC::ex solution_from(const LinearEquation& equation, const GiNaC::ex& start, const GiNaC::ex& angle,
                        const GiNaC::ex& rate);

}  // namespace rederive
