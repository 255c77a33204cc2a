#include <algorithm>
#include <derivations/manuscript/facts.hpp>
#include <functional>
#include <map>

namespace rederive::manuscript {

bool Facts::bind(const std::set<std::string>& names, std::size_t section, std::size_t display) const {
  std::set<std::string> reached = names;
  std::vector<bool> is_reached(facts_.size(), false);
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t k = 0; k < facts_.size(); ++k) {
      const bool touches =
          std::ranges::any_of(facts_[k].names, [&](const std::string& n) { return reached.contains(n); });
      if (is_reached[k] || !touches || !facts_[k].reaches(section, display)) continue;
      is_reached[k] = grows = true;
      reached.insert(facts_[k].names.begin(), facts_[k].names.end());
    }
  }
  std::map<std::string, std::size_t> solved_by;  // name → equation
  const std::function<bool(std::size_t, std::set<std::string>&)> has_name =
      [&](std::size_t fact, std::set<std::string>& tried) {
        for (const std::string& name : facts_[fact].names) {
          if (names.contains(name) || !tried.insert(name).second) continue;
          const auto other = solved_by.find(name);
          if (other != solved_by.end() && !has_name(other->second, tried)) continue;
          solved_by[name] = fact;
          return true;
        }
        return false;
      };
  for (std::size_t k = 0; k < facts_.size(); ++k) {
    if (!is_reached[k]) continue;
    std::set<std::string> tried;
    if (!has_name(k, tried)) return true;
  }
  return false;
}

}  // namespace rederive::manuscript
