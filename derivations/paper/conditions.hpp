// What the declared ranges say of several symbols.
#pragma once

#include <derivations/paper/paper.hpp>
#include <set>
#include <string>
#include <vector>

namespace rederive::paper {

/// Those of the paper's conditions that say something of one of these names, or of a symbol in another one of
/// them.
std::vector<language::Relation> declared_conditions_on(const Paper& paper, std::set<std::string> names);

}  // namespace rederive::paper
