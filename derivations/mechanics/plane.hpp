// Vectors in the plane, motion in polar coordinates, generalised forces, and the equation of motion by Newton
// and Euler: moments about a point that may itself move.
#pragma once

#include <derivations/mechanics/body.hpp>
#include <derivations/mechanics/signs.hpp>
#include <derivations/mechanics/time_derivative.hpp>
#include <vector>

namespace rederive::mechanics {

/// A vector by its components to the right and upwards.
struct Vector {
  GiNaC::ex right, up;
};
Vector operator+(const Vector& a, const Vector& b);
Vector operator-(const Vector& a, const Vector& b);
Vector operator*(const GiNaC::ex& factor, const Vector& a);
GiNaC::ex dot(const Vector& a, const Vector& b);
/// Returns a × b, positive if the turn from a to b is clockwise, as θ is in Fig. 2.
GiNaC::ex clockwise_cross(const Vector& a, const Vector& b);
/// Returns `a` turned clockwise by `angle`, in rad.
Vector turned_clockwise(const Vector& a, const GiNaC::ex& angle);
/// Returns the time derivative of each component (time_derivative.hpp).
Vector time_derivative(const Vector& a, const Rates& rates);

/// A force and its point of application, seen from the point about which moments are taken.
struct AppliedForce {
  Vector at, force;
};

/// Returns the clockwise moment of the forces about P minus the moment of the inertia of all elements,
/// Σ r × F − ∫ r × a dm, where r is seen from P and a is absolute. It is 0 in every motion, for every P.
/// `element` is the position of (x, y) seen from P, `carried` the position of P in the fixed frame, and
/// `rates` says which symbols change in time.
GiNaC::ex moment_balance(const RigidBody& body, const Vector& element, const Vector& carried,
                         const std::vector<AppliedForce>& forces, const Rates& rates);

/// Returns the generalised force Q = Σ F · ∂r/∂q, by virtual work. The points of application are seen from a
/// fixed point.
GiNaC::ex generalised_force(const std::vector<AppliedForce>& forces, const Coordinate& q);

/// A vector by its components outwards and in the direction in which the polar angle grows.
struct PolarVector {
  GiNaC::ex radial, transverse;
};
/// The velocity and the acceleration of the point r (cos φ, sin φ).
struct PolarMotion {
  PolarVector velocity, acceleration;
  std::vector<Step> steps;
};
PolarMotion polar_motion(const Coordinate& r, const Coordinate& phi);

}  // namespace rederive::mechanics
