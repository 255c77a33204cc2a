// What a witness says of the symbols that expressions stand for.
#pragma once

#include <derivations/algebra/prove.hpp>

namespace rederive {

/// Says that a symbol is an expression at the witness: as a rational number, or exactly and with digits. Does
/// nothing if it has no value there.
void put(Witness& witness, const std::string& name, const GiNaC::ex& value, const Symbols& symbols);

/// Puts in every symbol that is replaced, and any values for others that only these mention, or the sides of
/// the statements, where they make no difference.
void complete(Witness& witness, const std::vector<Tree>& sides, const std::vector<Given>& given,
              const Symbols& symbols);

}  // namespace rederive
