// What must hold for an expression to have a value at all, as far as the declared ranges do not grant it.
#pragma once

#include <derivations/algebra/prove.hpp>

namespace rederive {

/// "w != 0", "cos(theta) != 0", "x > 0": read off the tree as it was written, before anything cancels; not
/// what the givens grant. Throws Undecidable where these go round in a circle.
std::vector<std::string> side_conditions(const Tree& tree, const Symbols& symbols,
                                         const std::vector<Given>& given = {});

/// The same conditions with nothing said twice: x >= 0 and x != 0 are x > 0, which says both.
std::vector<std::string> said_once(const std::vector<std::string>& conditions);

/// What the tree divides by, factor by factor: none of it is 0 where the tree has a value.
std::vector<GiNaC::ex> divisors(const Tree& tree, const Symbols& symbols);

}  // namespace rederive
