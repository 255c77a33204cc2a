#include <derivations/paper/steps.hpp>

namespace rederive::paper {
using namespace language;
using namespace mechanics;

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

Derivation to_order(Derivation derivation, int order, const std::string& small) {
  derivation.order = order, derivation.small = small;
  return derivation;
}

Derivation assuming(Derivation derivation, const std::string& assumption) {
  derivation.assumption = assumption;
  return derivation;
}

Step in_words(std::string says) { return {std::move(says), 0, 0, "="}; }

Step from(const Derivation& other, std::string says) {
  return {std::move(says), other.left, other.right, other.relation};
}

Step from(const std::string& id, std::string says) {
  const std::string number = "(" + id + ")";
  const auto place = says.find('#');
  if (place == std::string::npos)
    says += " " + number;
  else
    says.replace(place, 1, number);
  return {.says = std::move(says), .left = 0, .right = 0, .cites = id};
}

std::vector<Step> as_before(std::initializer_list<Derivation> others, const std::vector<Step>& more) {
  std::vector<Step> steps;
  for (const Derivation& other : others) steps.insert(steps.end(), other.steps.begin(), other.steps.end());
  steps.insert(steps.end(), more.begin(), more.end());
  return steps;
}

}  // namespace rederive::paper
