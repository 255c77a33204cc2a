// All values are real here, which GiNaC does not know of.
#pragma once

#include <ginac/ginac.h>

namespace rederive {

/// The same for real values of all symbols and functions: what GiNaC thinks may be complex is its own
/// conjugate and its own real part. Throws std::domain_error where there is a number that is not real.
GiNaC::ex as_real(const GiNaC::ex& expression);

/// |x|, which is x for a root: GiNaC makes sqrt(|u|) of |sqrt(u)|, and forgets that u is not negative.
GiNaC::ex size_of(const GiNaC::ex& x);

/// The derivative by a symbol, as_real(): that of |f| has conjugates of f.
GiNaC::ex derivative(const GiNaC::ex& expression, const GiNaC::ex& symbol);

}  // namespace rederive
