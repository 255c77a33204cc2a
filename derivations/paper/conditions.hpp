// What the declared ranges say of several symbols.
#pragma once

#include <derivations/paper/paper.hpp>
#include <set>
#include <string>
#include <vector>

namespace rederive::paper {

/// Returns the paper's conditions on one of these names, or on a symbol in another condition that it returns.
std::vector<language::Relation> declared_conditions_on(const Paper& paper, std::set<std::string> names);

}  // namespace rederive::paper
