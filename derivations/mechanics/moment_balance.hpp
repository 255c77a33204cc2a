// The equation of motion by Newton and Euler: moments about a point that may itself move.
#pragma once

#include <derivations/mechanics/plane.hpp>
#include <vector>

namespace rederive {

/// A force and its point of application, seen from the point about which moments are taken.
struct AppliedForce {
  Vector at, force;
};

/// Returns the clockwise moment of the forces about P minus the moment of the inertia of all elements,
/// Σ r × F − ∫ r × a dm, where r is seen from P and a is absolute. It is 0 in every motion, for every P.
/// `element` is the position of (x, y) seen from P, `carried` the position of P in the fixed frame, and
/// `rates` says which symbols change in time.
GiNaC::ex moment_balance(const Rectangle& body, const Vector& element, const Vector& carried,
                         const std::vector<AppliedForce>& forces, const Rates& rates);

}  // namespace rederive
