#include <derivations/mechanics/time_derivative.hpp>
#include <stdexcept>

namespace rederive::mechanics {

using GiNaC::ex;

ex time_derivative(const ex& f, const Rates& rates) {
  ex sum = 0;
  for (const auto& [quantity, rate] : rates) sum += f.diff(quantity) * rate;
  return sum;
}

LagrangeTerms lagrange_terms(const ex& kinetic, const ex& potential, const Coordinate& q,
                             const Rates& rates) {
  if (potential.has(q.rate))
    throw std::invalid_argument("lagrange_terms: the potential depends on a velocity");
  const ex momentum = kinetic.diff(q.rate);
  return {momentum, time_derivative(momentum, rates), kinetic.diff(q.position), potential.diff(q.position)};
}

}  // namespace rederive::mechanics
