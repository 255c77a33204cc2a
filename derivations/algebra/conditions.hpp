// What must hold for an expression to have a value at all, as far as the declared ranges do not grant it.
#pragma once

#include <derivations/algebra/prove.hpp>

namespace rederive {

/// A value that is not 0, positive, or not negative.
struct Condition {
  GiNaC::ex value;
  std::string relation;  ///< to 0: "!=", ">" or ">="
};

/// As w != 0, cos(theta) != 0, x > 0: read off the tree as it was written, before anything cancels; not what
/// the givens grant. Throws Undecidable where these go round in a circle.
std::vector<Condition> conditions_of(const Tree& tree, const Symbols& symbols,
                                     const std::vector<Given>& given = {});

/// "x - 1 >= 0", in our syntax.
std::string in_words(const Condition& condition, const Symbols& symbols);

/// All of them, with nothing said twice: x >= 0 and x != 0 are x > 0, which says both.
std::vector<std::string> in_words(const std::vector<Condition>& conditions, const Symbols& symbols);

/// In words, all that must hold for all of these sides to have values.
std::vector<std::string> side_conditions(const std::vector<Tree>& sides, const Symbols& symbols,
                                         const std::vector<Given>& given);

/// All that must not be 0, be positive or not negative for a series in small symbols: what the ranges grant,
/// too, for its lowest terms may be 0 all the same; what stands between bars, and what has a symbolic
/// exponent.
std::vector<Condition> conditions_for_series(const Tree& tree, const Symbols& symbols,
                                             const std::vector<Given>& given);

/// Those of them, factor by factor, that the ranges do not grant.
std::vector<Condition> not_granted(const std::vector<Condition>& conditions, const Symbols& symbols,
                                   const std::vector<Given>& given);

/// Adds what has not been said.
void add_in_words(std::vector<std::string>& said, const std::vector<Condition>& conditions,
                  const Symbols& symbols);

/// What the tree divides by, factor by factor: none of it is 0 where the tree has a value.
std::vector<GiNaC::ex> divisors(const Tree& tree, const Symbols& symbols);

}  // namespace rederive
