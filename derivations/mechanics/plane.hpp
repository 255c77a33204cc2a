// Vectors in the plane, integrals over a homogeneous rectangle, and the equation of motion by Newton and
// Euler: moments about a point that may itself move.
#pragma once

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

/// Returns ∫ f dv from `from` to `to`. Throws std::invalid_argument if f is not a polynomial in v.
GiNaC::ex integral(const GiNaC::ex& f, const language::SymbolExpression& v, const GiNaC::ex& from,
                   const GiNaC::ex& to);

/// A rectangle of uniform density. (x, y) are its points at rest, seen from a point fixed in the body.
struct Rectangle {
  language::SymbolExpression x, y;
  GiNaC::ex left, right, bottom, top;  ///< x from left to right, y from bottom to top
  GiNaC::ex density;                   ///< mass per area
};
/// Returns ∫∫ ρ f dx dy: the mass for f = 1, a moment of inertia for f = x² + y², an energy for f = |v|²/2 …
/// Throws as integral does.
GiNaC::ex over_body(const GiNaC::ex& f, const Rectangle& body);

/// Returns the expression with 1 − cos² in place of every sin², expanded.
GiNaC::ex by_pythagoras(const GiNaC::ex& e);

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

}  // namespace rederive::mechanics
