// Newton and Euler's road to an equation of motion: moments about a point that may itself be moving.
#pragma once

#include <derivations/mechanics/plane.hpp>
#include <vector>

namespace rederive {

/// A force and where it acts, as seen from the point about which moments are taken.
struct AppliedForce {
  Vector at, force;
};

/// The clockwise moment of the forces about P less the one that the accelerations of all elements need,
/// Σ r × F − ∫ r × a dm, where r is seen from P and a is absolute. It vanishes in every motion. Nothing is
/// assumed about P. `element` is the position of (x, y) from P, `carried` the position of P in the fixed
/// frame.
GiNaC::ex moment_balance(const Rectangle& body, const Vector& element, const Vector& carried,
                         const std::vector<AppliedForce>& forces, const Rates& rates);

}  // namespace rederive
