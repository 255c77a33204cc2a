#include <derivations/mechanics/plane.hpp>

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

ex moment_balance(const RigidBody& body, const Vector& element, const Vector& carried,
                  const std::vector<AppliedForce>& forces, const Rates& rates) {
  const Vector velocity = time_derivative(carried + element, rates);
  const Vector acceleration = time_derivative(velocity, rates);
  ex sum = -over_body(clockwise_cross(element, acceleration), body);
  for (const AppliedForce& f : forces) sum += clockwise_cross(f.at, f.force);
  return by_pythagoras(sum);
}

ex generalised_force(const std::vector<AppliedForce>& forces, const Coordinate& q) {
  ex sum = 0;
  for (const AppliedForce& f : forces)
    sum += dot(f.force, {f.at.right.diff(q.position), f.at.up.diff(q.position)});
  return simplified(sum);
}

PolarMotion polar_motion(const Coordinate& r, const Coordinate& phi) {
  const Rates rates{
      {r.position, r.rate}, {r.rate, r.second_rate}, {phi.position, phi.rate}, {phi.rate, phi.second_rate}};
  const Vector outwards{cos(phi.position), sin(phi.position)}, across{-sin(phi.position), cos(phi.position)};
  const Vector velocity = time_derivative(r.position * outwards, rates);
  const Vector acceleration = time_derivative(velocity, rates);
  PolarMotion motion;
  const auto add = [&](PolarVector PolarMotion::*part, const Vector& vector, const char* says,
                       const std::string& name) {
    motion.*part = {by_pythagoras(dot(vector, outwards)), by_pythagoras(dot(vector, across))};
    motion.steps.push_back({says, GiNaC::symbol(name + "_x"), vector.right});
    motion.steps.push_back({"and", GiNaC::symbol(name + "_y"), vector.up});
    motion.steps.push_back(
        {"which has outwards the component", GiNaC::symbol(name + "_r"), (motion.*part).radial});
    motion.steps.push_back({"and across, in the direction of the angle,", GiNaC::symbol(name + "_phi"),
                            (motion.*part).transverse});
  };
  add(&PolarMotion::velocity, velocity, "Differentiate the position by time", "v");
  add(&PolarMotion::acceleration, acceleration, "Differentiate the velocity by time", "a");
  return motion;
}

}  // namespace rederive::mechanics
