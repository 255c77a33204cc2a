#include <derivations/rocking_block/letters.hpp>
#include <map>
#include <mutex>

namespace rederive {

using GiNaC::ex;

const Letters& letters() {
  static const Letters all;
  return all;
}

Rates block_rates() {
  const Letters& s = letters();
  return {{s.theta, s.thetadot}, {s.thetadot, s.thetaddot}, {s.u_g, s.u_gdot}, {s.u_gdot, s.u_gddot}};
}

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
  return remembered.emplace(derive, derive()).first->second;
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

std::vector<Given> inertia_and_frequency() {
  const Letters& s = letters();
  const ex R = 3 * s.g / (4 * pow(s.p, 2));
  return {{s.J_o, ex(4) / 3 * s.m * pow(R, 2)}, {s.R, R}};
}

std::vector<Given> sides_of_the_block() {
  const Letters& s = letters();
  return {{s.b, s.R * sin(s.alpha)}, {s.h, s.R * cos(s.alpha)}};
}

}  // namespace rederive
