// Derived expressions as source code, common subexpressions shared.
#pragma once

#include <derivations/emit/dialect.hpp>
#include <derivations/emit/taylor.hpp>
#include <map>
#include <string>
#include <vector>

namespace rederive {

/// One numeric function to write out.
struct EmittedFunction {
  std::string name;                           ///< "angular_acceleration_negative"
  std::vector<SymbolExpression> arguments;    ///< in order; the emission's symbols say units and ranges
  GiNaC::ex value;                            ///< of the arguments alone
  std::vector<SymbolExpression> derivatives;  ///< what name_with_derivatives gives beside it: d_psi …
  std::string equation;                       ///< the ledger row it stands for: "21a"
  std::string brief;                          ///< one line of documentation
};

/// What is emitted of a paper, and the symbols in it: those of the paper, and those that only numeric
/// functions have, such as the ratio omega_p/p.
struct Emission {
  Symbols symbols;
  std::vector<EmittedFunction> functions;
  std::vector<TaylorStepper> steppers = {};
};

/// One self-contained source text, the same bytes every time. `sharing` = common subexpressions get names.
/// Throws std::invalid_argument if a value has other symbols than its arguments or is dimensionally wrong, or
/// if there are steppers and the target is neither C++ nor JavaScript.
std::string emit(const Emission& emission, Target target, bool sharing = true);

/// By the name of the language: "cpp", "c" …
const std::map<std::string, Target>& targets();

/// The functions and steppers with these names, in the order in which they are listed; all that the target
/// has if nothing is named. Throws BadInput for a name that there is not, or not in this target.
Emission chosen_from(Emission all, const std::vector<std::string>& names, Target target);

/// What is known about a function beside its text.
struct Provenance {
  std::string unit;                           ///< of the value, in our syntax of units
  std::size_t operations, shared_operations;  ///< value and derivatives, before and after sharing
  std::string hash;  ///< of the equation's id and the printed expression: FNV-1a, 64 bits
};
/// Throws std::invalid_argument as `emit` does.
Provenance provenance(const EmittedFunction& function, const Symbols& symbols);
std::string hash_of(const std::string& text);
/// "alpha: angle of the diagonal from the vertical, atan(b/h); 1, (0, pi/2)"
std::string line_about(const Symbol& symbol);

}  // namespace rederive
