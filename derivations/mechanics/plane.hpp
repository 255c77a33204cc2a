// Vectors of the plane, and what a body in it adds up to: integrals over a homogeneous rectangle.
#pragma once

#include <derivations/mechanics/time_derivative.hpp>

namespace rederive {

/// Components to the right and upwards.
struct Vector {
  GiNaC::ex right, up;
};
Vector operator+(const Vector& a, const Vector& b);
Vector operator-(const Vector& a, const Vector& b);
Vector operator*(const GiNaC::ex& factor, const Vector& a);
GiNaC::ex dot(const Vector& a, const Vector& b);
/// a × b, counted positive when it turns from a to b clockwise, as θ is in Fig. 2.
GiNaC::ex clockwise_cross(const Vector& a, const Vector& b);
/// `a` turned clockwise by `angle`.
Vector turned_clockwise(const Vector& a, const GiNaC::ex& angle);
/// Of each component (time_derivative.hpp).
Vector time_derivative(const Vector& a, const Rates& rates);

/// ∫ f dv from `from` to `to`; f must be a polynomial in v. Throws std::invalid_argument where it is not.
GiNaC::ex integral(const GiNaC::ex& f, const SymbolExpression& v, const GiNaC::ex& from, const GiNaC::ex& to);

/// A rectangle of uniform density; (x, y) run over its points at rest, seen from a point fixed in the body.
struct Rectangle {
  SymbolExpression x, y;
  GiNaC::ex left, right, bottom, top;  ///< x from left to right, y from bottom to top
  GiNaC::ex density;                   ///< mass per area
};
/// ∫∫ ρ f dx dy: the mass for f = 1, an inertia for f = x² + y², an energy for f = |v|²/2 … Throws as
/// integral does.
GiNaC::ex over_body(const GiNaC::ex& f, const Rectangle& body);

/// sin² → 1 − cos² of every argument, expanded.
GiNaC::ex by_pythagoras(const GiNaC::ex& e);

}  // namespace rederive
