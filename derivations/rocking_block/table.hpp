// Which function derives which equation of the paper.
#pragma once

#include <derivations/mechanics/derivation.hpp>
#include <map>
#include <string>

namespace rederive {

/// Equation id ("21a", "u3", "r1") → its derivation. Adding an equation adds a line here.
const std::map<std::string, Derive>& derivation_table();

}  // namespace rederive
