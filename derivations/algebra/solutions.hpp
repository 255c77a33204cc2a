// Assumptions that are equations of one symbol: sin(alpha) = 1/2.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>
#include <vector>

namespace rederive {

/// All values of the one symbol in the residual, within its declared range, at which the residual is 0; by
/// undoing one function or power after the other, where the symbol stands in one term only; or of a
/// polynomial with factors of degree 1 and 2, be it one in tan(x/2). Nothing where that fails, and where
/// there are infinitely many.
std::optional<std::vector<GiNaC::ex>> solutions(const GiNaC::ex& residual, const Symbols& symbols);

/// Whether it certainly has no value, wherever the symbols are in their declared ranges: log(x) with x < 0.
bool has_no_value(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive
