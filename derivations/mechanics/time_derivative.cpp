#include <derivations/mechanics/time_derivative.hpp>
#include <stdexcept>

namespace rederive::mechanics {

using namespace language;

using GiNaC::ex;

ex time_derivative(const ex& f, const Rates& rates) {
  ex sum = 0;
  for (const auto& [quantity, rate] : rates) sum += f.diff(quantity) * rate;
  return sum;
}

LagrangeTerms lagrange_terms(const ex& kinetic, const ex& potential, const Coordinate& q, const Rates& rates,
                             const ex& dissipation, const ex& force) {
  if (potential.has(q.rate))
    throw std::invalid_argument("lagrange_terms: the potential depends on a velocity");
  const ex momentum = kinetic.diff(q.rate);
  LagrangeTerms terms{momentum,
                      time_derivative(momentum, rates),
                      kinetic.diff(q.position),
                      potential.diff(q.position),
                      dissipation.diff(q.rate),
                      force,
                      {}};
  const auto add = [&](const char* says, const char* name, const SymbolExpression& by, const ex& value) {
    const GiNaC::symbol left(name + GiNaC::ex_to<GiNaC::symbol>(by).get_name());
    if (!value.is_zero()) terms.steps.push_back({says, left, value});
  };
  add("The kinetic energy, differentiated by the rate, is the momentum", "dK_d", q.rate, momentum);
  add("which changes in time by", "ddt_dK_d", q.rate, terms.momentum_rate);
  add("Differentiated by the coordinate, the kinetic energy gives", "dK_d", q.position, terms.kinetic_slope);
  add("and the potential", "dOmega_d", q.position, terms.potential_slope);
  add("The dissipation, differentiated by the rate, gives", "dD_d", q.rate, terms.dissipation_slope);
  add("The generalised force is", "Q_", q.position, force);
  terms.steps.push_back({"By Lagrange's equation", terms.sum().expand(), 0});
  return terms;
}

}  // namespace rederive::mechanics
