// Functions by others: tan u = sin u/cos u, and where they have values.
#pragma once

#include <derivations/identity/signs.hpp>
#include <derivations/language/tree.hpp>
#include <utility>

namespace rederive {

/// What must hold for f(u) to have a value, and what it is there.
struct RewriteRule {
  std::vector<std::pair<Tree, Signs>> domain;  ///< of values in u
  Tree result;                                 ///< in u; null of a function that is not replaced
};

/// The rule of a function of our syntax, by its name; nullptr where it has a value everywhere and is not
/// replaced.
const RewriteRule* rewrite_rule(const std::string& function);

}  // namespace rederive
