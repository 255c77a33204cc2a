// Where a statement has values, in words.
#pragma once

#include <derivations/identity/translator.hpp>

namespace rederive {

/// "x - 1 > 0", "cos(theta) != 0": the conditions in our syntax, without the factors of which the ring knows
/// the sign, and nothing said twice; x >= 0 and x != 0 are x > 0.
std::vector<std::string> in_words(const std::vector<DomainCondition>& conditions, const Ring& ring,
                                  const Symbols& symbols);

}  // namespace rederive
