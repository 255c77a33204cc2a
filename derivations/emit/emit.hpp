// Writes derived expressions as source code, with common subexpressions shared.
#pragma once

#include <derivations/emit/dialect.hpp>
#include <derivations/emit/taylor.hpp>
#include <map>
#include <string>
#include <vector>

namespace rederive::emit {

/// One numeric function that is written as code.
struct EmittedFunction {
  std::string name;  ///< "angular_acceleration_negative"
  std::vector<language::SymbolExpression>
      arguments;    ///< in order; the emission's symbols say units and ranges
  GiNaC::ex value;  ///< in the arguments alone
  std::vector<language::SymbolExpression>
      derivatives;       ///< name_with_derivatives also returns d_psi … for these
  std::string equation;  ///< the id of the row that it computes: "21a"
  std::string brief;     ///< one line of documentation
};

/// The functions and steppers of a paper, and their symbols: those of the paper, and those that only numeric
/// functions have, such as the ratio omega_p/p.
struct Emission {
  language::Symbols symbols;
  std::vector<EmittedFunction> functions;
  std::vector<TaylorStepper> steppers = {};
  std::string units = "Units are SI.";  ///< a sentence for the head of the source text
};

/// Returns the emission as one self-contained source text, the same bytes every time. With `sharing`, common
/// subexpressions get names. Throws std::invalid_argument, with the name of the function, if a value has a
/// symbol that is not an argument or has terms of different dimensions, and if there are steppers and the
/// target is neither C++ nor JavaScript.
std::string emit(const Emission& emission, Target target, bool sharing = true);

/// Returns the targets by the names of their languages: "cpp", "c" …
const std::map<std::string, Target>& targets();

/// Returns the functions and steppers with these names, in the order of `all`; without names, everything that
/// the target can write. Throws BadInput for an unknown name, and for a stepper that the target cannot write.
Emission chosen_from(Emission all, const std::vector<std::string>& names, Target target);

/// What is known about an emitted function besides its text.
struct Provenance {
  std::string unit;                           ///< of the value, in our syntax of units
  std::size_t operations, shared_operations;  ///< value and derivatives, before and after sharing
  std::string hash;  ///< of the equation's id and the printed expression: FNV-1a, 64 bits
};
/// Returns it for a function. Throws std::invalid_argument as `emit` does.
Provenance provenance(const EmittedFunction& function, const language::Symbols& symbols);
/// Returns the hash of a text as 16 hexadecimal digits: FNV-1a, 64 bits.
std::string hash_of(const std::string& text);
/// Returns what is declared about a symbol: "alpha: angle of the diagonal …, atan(b/h); 1, (0, pi/2)".
std::string line_about(const language::Symbol& symbol);

}  // namespace rederive::emit
