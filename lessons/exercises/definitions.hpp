// What the paper's names stand for wherever they are used.
#pragma once

#include <derivations/algebra/prove.hpp>

#include <set>
#include <string>
#include <vector>

namespace rederive::classroom {

/// Adds to `given` those of b, h, J_c, J_o and R = 3g/(4p²) that can be said in the symbols at hand, so that an answer
/// may use either; never the name that is being asked for.
void add_definitions(std::vector<Given>& given, const std::set<std::string>& at_hand, const std::string& asked_for);

}  // namespace rederive::classroom
