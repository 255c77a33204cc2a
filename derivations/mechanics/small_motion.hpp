// Small motions about a state: linearisation of equations of motion, and the normal modes of M q̈ + K q = 0.
#pragma once

#include <derivations/mechanics/solve.hpp>
#include <derivations/mechanics/time_derivative.hpp>

namespace rederive::mechanics {

/// The equations M q̈ + C q̇ + K q + residual = 0 of deviations q from a state.
struct LinearSystem {
  GiNaC::matrix mass, damping, stiffness;
  std::vector<GiNaC::ex> residual;  ///< 0 if the state is an equilibrium or a motion
  std::vector<Step> steps;
};
/// Returns the equations to first order in the deviations from `state`, which gives coordinates, rates and
/// second rates; those that it leaves out are 0 there. An equation is an expression that is 0. Throws
/// std::invalid_argument if there are not as many equations as coordinates.
LinearSystem linearised(const std::vector<GiNaC::ex>& equations, const std::vector<Coordinate>& coordinates,
                        const std::vector<language::Given>& state = {});

/// A motion q = shape · cos(frequency · t) of all coordinates.
struct Mode {
  GiNaC::ex square;                    ///< of the frequency
  std::optional<GiNaC::ex> frequency;  ///< nothing if the square is negative: the state is unstable
  std::vector<GiNaC::ex> shape;        ///< the first component that is not 0 is 1
};
struct Modes {
  GiNaC::ex polynomial;     ///< det(K − λ M) in λ
  std::vector<Mode> modes;  ///< by increasing frequency, where that can be proved
  std::vector<Step> steps;
  std::vector<Step> conditions;
};
/// Returns the modes of M q̈ + K q = 0 with up to three degrees of freedom; `lambda` names the square of the
/// frequency. A polynomial of degree 3 without a rational factor has three real roots in terms of an arc
/// cosine. Throws std::invalid_argument if the matrices are not symmetric or of another size, or if M is not
/// positive definite; where that is not certain, it is a condition.
Modes modes_of(const GiNaC::matrix& mass, const GiNaC::matrix& stiffness,
               const language::SymbolExpression& lambda, const Relations& known = {});

}  // namespace rederive::mechanics
