#include <derivations/mechanics/plane.hpp>
#include <stdexcept>

namespace rederive::mechanics {
using namespace language;

using GiNaC::ex;

Vector operator+(const Vector& a, const Vector& b) { return {a.right + b.right, a.up + b.up}; }
Vector operator-(const Vector& a, const Vector& b) { return {a.right - b.right, a.up - b.up}; }
Vector operator*(const ex& factor, const Vector& a) { return {factor * a.right, factor * a.up}; }
ex dot(const Vector& a, const Vector& b) { return a.right * b.right + a.up * b.up; }
ex clockwise_cross(const Vector& a, const Vector& b) { return a.up * b.right - a.right * b.up; }

Vector turned_clockwise(const Vector& a, const ex& angle) {
  return {a.right * cos(angle) + a.up * sin(angle), a.up * cos(angle) - a.right * sin(angle)};
}

Vector time_derivative(const Vector& a, const Rates& rates) {
  return {time_derivative(a.right, rates), time_derivative(a.up, rates)};
}

ex integral(const ex& f, const SymbolExpression& v, const ex& from, const ex& to) {
  const ex expanded = f.expand();
  if (!expanded.is_polynomial(v)) throw std::invalid_argument("integral: the integrand is not a polynomial");
  ex sum = 0;
  for (int n = expanded.ldegree(v); n <= expanded.degree(v); ++n)
    sum += expanded.coeff(v, n) * (pow(to, n + 1) - pow(from, n + 1)) / (n + 1);
  return sum.expand();
}

ex over_body(const ex& f, const Rectangle& body) {
  const ex strip = integral(body.density * f, body.y, body.bottom, body.top);
  return integral(strip, body.x, body.left, body.right);
}

ex by_pythagoras(const ex& e) {
  const ex any = GiNaC::wild();
  return e.expand().subs(pow(sin(any), 2) == 1 - pow(cos(any), 2)).expand();
}

ex moment_balance(const Rectangle& body, const Vector& element, const Vector& carried,
                  const std::vector<AppliedForce>& forces, const Rates& rates) {
  const Vector velocity = time_derivative(carried + element, rates);
  const Vector acceleration = time_derivative(velocity, rates);
  ex sum = -over_body(clockwise_cross(element, acceleration), body);
  for (const AppliedForce& f : forces) sum += clockwise_cross(f.at, f.force);
  return by_pythagoras(sum);
}

}  // namespace rederive::mechanics
