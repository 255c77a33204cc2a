// Which function derives which equation of the paper.
#pragma once

#include <derivations/rocking_block/steps.hpp>
#include <map>
#include <string>

namespace rederive {

/// Equation id ("21a", "u3a", "r1") → its derivation: the lists of all sections. Throws std::invalid_argument
/// if two derive the same.
const std::map<std::string, Derive>& derivation_table();

/// Puts the derivations of another paper in the place of these, for the rest of the run. Throws
/// std::invalid_argument if two derive the same.
void derive_instead(const Derivations& other);

}  // namespace rederive
