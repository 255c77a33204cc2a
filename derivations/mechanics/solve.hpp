// Systems of linear equations with symbolic coefficients.
#pragma once

#include <derivations/mechanics/derivation.hpp>
#include <derivations/mechanics/signs.hpp>

namespace rederive::mechanics {

/// The values of the unknowns, in the order in which these were given.
struct Solution {
  std::vector<language::Given> values;
  std::vector<Step> steps;
  std::vector<Step> conditions;  ///< a − b ≠ 0: factors of pivots that may vanish
  /// Returns e with the values in place of the unknowns.
  GiNaC::ex in(const GiNaC::ex& e) const;
};

/// Solves linear equations, by elimination. An equation is left == right, or an expression that is 0. Pivots
/// that cannot vanish are used first: numbers, then expressions of one sign by what GiNaC knows of their
/// symbols and by `known`. There may be more equations than unknowns. Throws std::invalid_argument if an
/// equation is not linear in the unknowns, if the equations contradict each other, or if they leave an
/// unknown undetermined.
Solution solve(const std::vector<GiNaC::ex>& equations,
               const std::vector<language::SymbolExpression>& unknowns, const Relations& known = {});

/// Returns e ≠ 0 as conditions on those factors of e that may vanish.
std::vector<Step> not_zero(const GiNaC::ex& e, const Relations& known = {});

/// Adds conditions to a list, each once.
void add_conditions(std::vector<Step>& conditions, const std::vector<Step>& more);

/// Returns a basis of the vectors v with A v = 0; the first component of each that is not 0 is 1.
/// Adds what the pivots need to `conditions`.
std::vector<std::vector<GiNaC::ex>> null_space(const GiNaC::matrix& a, const Relations& known,
                                               std::vector<Step>& conditions);

}  // namespace rederive::mechanics
