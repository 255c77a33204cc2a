// Derived expressions as source code, common subexpressions shared.
#pragma once

#include <derivations/algebra/symbols.hpp>
#include <string>
#include <vector>

namespace rederive {

/// One numeric function to write out.
struct EmittedFunction {
  std::string name;                         ///< "angular_acceleration_negative"
  std::vector<SymbolExpression> arguments;  ///< in order; units and ranges come from the symbol table
  GiNaC::ex value;
  std::vector<SymbolExpression>
      derivatives;       ///< what stands beside it: a struct {value, d_psi, …} in name_with_derivatives
  std::string equation;  ///< the ledger row it stands for: "21a"
  std::string brief;     ///< one line of documentation
};

enum class Target { cpp, c, python, javascript, latex };

/// Every function that is emitted, built from the derivations.
std::vector<EmittedFunction> emitted_functions();

/// One self-contained source text, the same bytes every time. `sharing` = common subexpressions get names.
std::string emit(const std::vector<EmittedFunction>& functions, Target target, bool sharing = true);

}  // namespace rederive
