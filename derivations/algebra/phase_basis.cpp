#include <derivations/algebra/phase_basis.hpp>
#include <stdexcept>

namespace rederive {

using GiNaC::ex;
using GiNaC::numeric;

std::vector<numeric> PhaseBasis::take_off(Monomials& monomials) const {
  std::vector<numeric> taken(phases_.size(), 0);
  for (const Row& row : rows_) {
    const auto found = monomials.find(row.pivot);
    if (found == monomials.end()) continue;
    const numeric times = found->second / row.monomials.at(row.pivot);
    for (const auto& [monomial, number] : row.monomials)
      if ((monomials[monomial] -= times * number).is_zero()) monomials.erase(monomial);
    for (std::size_t k = 0; k < row.combination.size(); ++k) taken[k] += times * row.combination[k];
  }
  return taken;
}

void PhaseBasis::add(const ex& phase, const Monomials& monomials) {
  Monomials rest = monomials;
  std::vector<numeric> combination = take_off(rest);
  if (rest.empty()) return;
  for (numeric& number : combination) number = -number;
  combination.push_back(1);
  phases_.push_back(phase);
  rows_.push_back({rest.begin()->first, rest, combination});
}

std::vector<numeric> PhaseBasis::coefficients(const Monomials& monomials) const {
  Monomials rest = monomials;
  std::vector<numeric> result = take_off(rest);
  if (!rest.empty()) throw std::out_of_range("no combination of these phases");
  return result;
}

}  // namespace rederive
