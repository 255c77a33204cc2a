// Bodies of uniform density in space: integrals over them, mass, centre of mass and moments of inertia.
#pragma once

#include <array>
#include <derivations/mechanics/derivation.hpp>

namespace rederive::mechanics {

/// A point or a direction by its components x, y, z; plane motion is in x and y.
using Position = std::array<GiNaC::ex, 3>;

/// Returns ∫ f dv from `from` to `to`. Throws std::invalid_argument if f is not a polynomial in v, or one in
/// sin v and cos v.
GiNaC::ex integral(const GiNaC::ex& f, const language::SymbolExpression& v, const GiNaC::ex& from,
                   const GiNaC::ex& to);

/// A parameter of the elements of a body, and its bounds.
struct Parameter {
  language::SymbolExpression name;
  GiNaC::ex from, to;
};

/// A body of uniform density. Its elements are the values of `element`, seen from a point fixed in the body,
/// over one, two or three parameters; bounds may contain the parameters that come later.
struct RigidBody {
  Position element;
  std::vector<Parameter> over;
  GiNaC::ex density;  ///< mass per length, area or volume, by the number of parameters
};

/// Returns the body of this mass. A negative mass is a hole.
RigidBody homogeneous(const GiNaC::ex& mass, const Position& element, const std::vector<Parameter>& over);
/// Returns the rectangle in x and y with x from left to right and y from bottom to top.
RigidBody rectangle(const language::SymbolExpression& x, const language::SymbolExpression& y,
                    const GiNaC::ex& left, const GiNaC::ex& right, const GiNaC::ex& bottom,
                    const GiNaC::ex& top, const GiNaC::ex& density);
/// Return bodies with their centre at the origin: a rod along x, a disc and a thin ring in the plane of x and
/// y, the part of a disc between two radii, and a cylinder with its axis along z.
RigidBody rod(const GiNaC::ex& mass, const GiNaC::ex& length);
RigidBody disc(const GiNaC::ex& mass, const GiNaC::ex& radius);
RigidBody ring(const GiNaC::ex& mass, const GiNaC::ex& radius);
RigidBody ring(const GiNaC::ex& mass, const GiNaC::ex& inner_radius, const GiNaC::ex& outer_radius);
RigidBody cylinder(const GiNaC::ex& mass, const GiNaC::ex& radius, const GiNaC::ex& length);
/// Returns the body turned by `angle` from x to y about the origin, and then moved.
RigidBody placed(RigidBody body, const Position& by, const GiNaC::ex& angle = 0);

/// Returns ∫ ρ f over the body: the mass for f = 1, a moment of inertia for f = x² + y², an energy for f =
/// |v|²/2 … The size of an element comes from the derivatives of `element`. Throws as integral does.
GiNaC::ex over_body(const GiNaC::ex& f, const RigidBody& body);

/// The mass of bodies, their centre, and the moment of inertia about the axis through the centre.
struct MassProperties {
  GiNaC::ex mass = 0;
  Position centre = {};
  GiNaC::ex inertia = 0;
  Position axis = {0, 0, 1};  ///< its direction, of length 1
  std::vector<Step> steps = {};
};
/// Returns the properties of several bodies that move as one, by integration. Throws std::invalid_argument if
/// their mass is 0.
MassProperties mass_properties(const std::vector<RigidBody>& bodies, const Position& axis = {0, 0, 1});
/// Returns the moment of inertia about the parallel axis through `point`.
GiNaC::ex about_parallel_axis(const MassProperties& properties, const Position& point);

}  // namespace rederive::mechanics
