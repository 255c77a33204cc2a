#include <algorithm>
#include <derivations/decide/problem.hpp>
#include <derivations/paper/conditions.hpp>

namespace rederive::paper {
using namespace language;
using namespace decide;

std::vector<Relation> declared_conditions_on(const Paper& paper, std::set<std::string> names) {
  std::vector<Relation> result, others = paper.conditions;
  for (bool has_grown = true; has_grown;) {
    has_grown = false;
    std::erase_if(others, [&](const Relation& condition) {
      const std::set<std::string> its_names = names_of(condition);
      if (std::ranges::none_of(its_names, [&](auto& name) { return names.contains(name); })) return false;
      names.insert(its_names.begin(), its_names.end());
      result.push_back(condition);
      return has_grown = true;
    });
  }
  return result;
}

}  // namespace rederive::paper
