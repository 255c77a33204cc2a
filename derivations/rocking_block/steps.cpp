#include <derivations/rocking_block/steps.hpp>
#include <map>
#include <mutex>
#include <set>
#include <stdexcept>

namespace rederive {

using GiNaC::ex;

Derivation derived(const ex& left, const ex& right, std::vector<Step> steps, std::vector<Given> given,
                   const std::string& relation) {
  Derivation result;
  result.left = left;
  result.right = right;
  result.relation = relation;
  result.steps = std::move(steps);
  result.steps.push_back({"Hence", left, right, relation});
  result.given = std::move(given);
  return result;
}

Step in_words(std::string says) { return {std::move(says), 0, 0, "="}; }

Step from(const Derivation& other, std::string says) {
  return {std::move(says), other.left, other.right, other.relation};
}

const Derivation& Cited::derivation() const {
  static std::map<Derive, Derivation> remembered;
  static std::recursive_mutex guard;
  const std::lock_guard lock(guard);
  if (const auto found = remembered.find(derive); found != remembered.end()) return found->second;
  static std::set<Derive> under_way;
  if (!under_way.insert(derive).second) throw std::logic_error("(" + number + ") is derived from itself");
  try {
    const Derivation derivation = derive();
    under_way.erase(derive);
    return remembered.emplace(derive, derivation).first->second;
  } catch (...) {
    under_way.erase(derive);
    throw;
  }
}

Step from(const Cited& other, std::string says) {
  const std::string number = "(" + other.number + ")";
  const auto place = says.find('#');
  if (place == std::string::npos)
    says += " " + number;
  else
    says.replace(place, 1, number);
  return from(other.derivation(), std::move(says));
}

std::vector<Step> as_before(std::initializer_list<Derivation> others, const std::vector<Step>& more) {
  std::vector<Step> steps;
  for (const Derivation& other : others) steps.insert(steps.end(), other.steps.begin(), other.steps.end());
  steps.insert(steps.end(), more.begin(), more.end());
  return steps;
}

}  // namespace rederive
