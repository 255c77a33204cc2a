// The factor between two residuals, as a product whose parts can be looked at one by one.
#pragma once

#include <derivations/algebra/factor_form.hpp>

namespace rederive {

/// How a quotient is brought into lowest terms: no way finds everything that cancels.
enum class Way { real_denominator, complex_numbers, no_roots_above };

/// left/right as a product of named parts, if it is one. Throws Undecidable.
std::optional<std::vector<Part>> quotient(const GiNaC::ex& left, const GiNaC::ex& right,
                                          const Symbols& symbols, Way way);

}  // namespace rederive
