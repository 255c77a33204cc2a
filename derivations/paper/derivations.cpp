#include <derivations/paper/derivations.hpp>
#include <stdexcept>

namespace rederive {

Derivations::Derivations(std::initializer_list<std::pair<std::string, Derive>> list) {
  for (const auto& [id, derive] : list)
    if (!all_.emplace(id, std::pair(derive, Once<Derivation>())).second)
      throw std::invalid_argument("equation (" + id + ") is derived twice");
}

void Derivations::add(const Derivations& others) {
  for (const auto& one : others.all_)
    if (!all_.insert(one).second)
      throw std::invalid_argument("equation (" + one.first + ") is derived twice");
}

std::vector<std::string> Derivations::ids() const {
  std::vector<std::string> result;
  for (const auto& [id, one] : all_) result.push_back(id);
  return result;
}

const Derivation& Derivations::at(const std::string& id) const {
  const auto& [derive, once] = all_.at(id);
  return once(derive);
}

}  // namespace rederive
