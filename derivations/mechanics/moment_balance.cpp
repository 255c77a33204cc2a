#include <derivations/mechanics/moment_balance.hpp>

namespace rederive {

using GiNaC::ex;

ex moment_balance(const Rectangle& body, const Vector& element, const Vector& carried,
                  const std::vector<AppliedForce>& forces, const Rates& rates) {
  const Vector velocity = time_derivative(carried + element, rates);
  const Vector acceleration = time_derivative(velocity, rates);
  ex sum = -over_body(clockwise_cross(element, acceleration), body);
  for (const AppliedForce& f : forces) sum += clockwise_cross(f.at, f.force);
  return by_pythagoras(sum);
}

}  // namespace rederive
