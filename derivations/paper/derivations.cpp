#include <derivations/paper/derivations.hpp>
#include <stdexcept>

namespace rederive::paper {
using namespace mechanics;

Derivations::Derivations(std::initializer_list<std::pair<std::string, Derive>> list) {
  for (const auto& [id, derive] : list) add(id, derive);
}

void Derivations::add(const std::string& id, Derive derive) {
  if (!all_.emplace(id, std::pair(std::move(derive), Once<Derivation>())).second)
    throw std::invalid_argument("equation (" + id + ") is derived twice");
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

}  // namespace rederive::paper
