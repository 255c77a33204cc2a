// Is this expression identically zero? The heart of prove.
#pragma once

#include <derivations/algebra/phases.hpp>

namespace rederive {

/// True only if `expression` vanishes wherever it is defined inside the declared ranges. Throws Undecidable
/// where it is outside the class. False says only that it was not shown to vanish.
bool vanishes(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive
