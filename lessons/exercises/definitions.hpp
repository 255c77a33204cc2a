// What the paper's names stand for wherever they are used.
#pragma once

#include <derivations/mechanics/derivation.hpp>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace rederive::classroom {

/// Adds to `given` those of b, h, J_c, J_o and R = 3g/(4p²) that can be said in the symbols at hand, so that
/// an answer may use either; never the name that is being asked for.
void add_definitions(std::vector<Given>& given, const std::set<std::string>& at_hand,
                     const std::string& asked_for);

/// Derivations that exercises name and that the paper does not have, by name: the two below.
const std::map<std::string, Derivation (*)()>& derivations_of_exercises();
/// e of a light block with a point mass in the middle of its top face: the moment of the momentum about the
/// new corner is kept. In b and h.
Derivation mass_at_the_top();
/// The condition of (71) for a pulse that stops after half a sine, when its argument is pi.
Derivation half_sine();

}  // namespace rederive::classroom
