#include <derivations/mechanics/body.hpp>
#include <derivations/mechanics/signs.hpp>
#include <stdexcept>

namespace rederive::mechanics {
using namespace language;

using GiNaC::ex;

namespace {

/// Returns ∫ cosⁿ v dv.
ex of_cosine_power(int n, const ex& v) {
  if (n == 0) return v;
  if (n == 1) return sin(v);
  return pow(cos(v), n - 1) * sin(v) / n + ex(n - 1) / n * of_cosine_power(n - 2, v);
}

/// Returns the antiderivative of f, a polynomial in v, or one in sin v and cos v.
ex antiderivative(const ex& f, const SymbolExpression& v) {
  const ex expanded = f.expand();
  ex sum = 0;
  if (expanded.is_polynomial(v)) {
    for (int n = expanded.ldegree(v); n <= expanded.degree(v); ++n)
      sum += expanded.coeff(v, n) * pow(v, n + 1) / (n + 1);
    return sum;
  }
  const GiNaC::symbol c("c"), s("s");
  const ex in_symbols = by_pythagoras(f).subs(GiNaC::lst{cos(v) == c, sin(v) == s}).expand();
  if (in_symbols.has(v) || !in_symbols.is_polynomial(GiNaC::lst{c, s}))
    throw std::invalid_argument("integral: the integrand is neither a polynomial nor one in sine and cosine");
  for (int n = 0; n <= in_symbols.degree(c); ++n) {
    const ex factor = in_symbols.coeff(c, n);
    sum += factor.coeff(s, 0) * of_cosine_power(n, v) - factor.coeff(s, 1) * pow(cos(v), n + 1) / (n + 1);
  }
  return sum;
}

ex dot(const Position& a, const Position& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Position operator-(const Position& a, const Position& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }

/// Returns the squared distance of a point at `arm` from an axis through the origin.
ex squared_distance(const Position& arm, const Position& axis) {
  return dot(arm, arm) - pow(dot(arm, axis), 2);
}

/// Returns the size of an element: a root of the determinant of the products of its edges.
ex size_of_element(const RigidBody& body) {
  const auto n = static_cast<unsigned>(body.over.size());
  GiNaC::matrix products(n, n);
  const auto edge = [&](unsigned k) {
    const GiNaC::symbol& v = body.over[k].name;
    return Position{body.element[0].diff(v), body.element[1].diff(v), body.element[2].diff(v)};
  };
  for (unsigned i = 0; i < n; ++i)
    for (unsigned k = 0; k < n; ++k) products(i, k) = dot(edge(i), edge(k));
  return root_of(by_pythagoras(products.determinant()));
}

SymbolExpression parameter(const char* name) { return SymbolExpression(GiNaC::possymbol(name)); }

}  // namespace

ex integral(const ex& f, const SymbolExpression& v, const ex& from, const ex& to) {
  const ex primitive = antiderivative(f, v);
  return (primitive.subs(v == to) - primitive.subs(v == from)).expand();
}

ex over_body(const ex& f, const RigidBody& body) {
  ex sum = body.density * f * size_of_element(body);
  for (const Parameter& parameter : body.over)
    sum = integral(sum, parameter.name, parameter.from, parameter.to);
  return sum;
}

RigidBody homogeneous(const ex& mass, const Position& element, const std::vector<Parameter>& over) {
  return {element, over, mass / over_body(1, {element, over, 1})};
}

RigidBody rectangle(const SymbolExpression& x, const SymbolExpression& y, const ex& left, const ex& right,
                    const ex& bottom, const ex& top, const ex& density) {
  return {{x, y, 0}, {{y, bottom, top}, {x, left, right}}, density};
}

RigidBody rod(const ex& mass, const ex& length) {
  const SymbolExpression x = parameter("x");
  return homogeneous(mass, {x, 0, 0}, {{x, -length / 2, length / 2}});
}

RigidBody disc(const ex& mass, const ex& radius) { return ring(mass, 0, radius); }

RigidBody ring(const ex& mass, const ex& radius) {
  const SymbolExpression phi = parameter("phi");
  return homogeneous(mass, {radius * cos(phi), radius * sin(phi), 0}, {{phi, 0, 2 * GiNaC::Pi}});
}

RigidBody ring(const ex& mass, const ex& inner_radius, const ex& outer_radius) {
  const SymbolExpression r = parameter("r"), phi = parameter("phi");
  return homogeneous(mass, {r * cos(phi), r * sin(phi), 0},
                     {{r, inner_radius, outer_radius}, {phi, 0, 2 * GiNaC::Pi}});
}

RigidBody cylinder(const ex& mass, const ex& radius, const ex& length) {
  const SymbolExpression r = parameter("r"), phi = parameter("phi"), z = parameter("z");
  return homogeneous(mass, {r * cos(phi), r * sin(phi), z},
                     {{r, 0, radius}, {phi, 0, 2 * GiNaC::Pi}, {z, -length / 2, length / 2}});
}

RigidBody placed(RigidBody body, const Position& by, const ex& angle) {
  const Position at = body.element;
  body.element = {at[0] * cos(angle) - at[1] * sin(angle) + by[0],
                  at[0] * sin(angle) + at[1] * cos(angle) + by[1], at[2] + by[2]};
  return body;
}

MassProperties mass_properties(const std::vector<RigidBody>& bodies, const Position& axis) {
  const auto over_all = [&](const auto& f) {
    ex sum = 0;
    for (const RigidBody& body : bodies) sum += over_body(f(body.element), body);
    return simplified(sum);
  };
  MassProperties all{.mass = over_all([](const Position&) { return ex(1); }), .axis = axis};
  all.steps.push_back({"Integrate the density over all elements", GiNaC::symbol("m"), all.mass});
  if (vanishes(all.mass)) throw std::invalid_argument("mass_properties: the mass of a body must not be 0");
  const char* const names[] = {"x_C", "y_C", "z_C"};
  for (std::size_t k = 0; k < all.centre.size(); ++k) {
    all.centre[k] = simplified(over_all([&](const Position& element) { return element[k]; }) / all.mass);
    all.steps.push_back({"and the position of each, by the mass", GiNaC::symbol(names[k]), all.centre[k]});
  }
  all.inertia =
      over_all([&](const Position& element) { return squared_distance(element - all.centre, axis); });
  all.steps.push_back({"and the squared distance of each from the axis through the centre of mass",
                       GiNaC::symbol("J_C"), all.inertia});
  return all;
}

ex about_parallel_axis(const MassProperties& properties, const Position& point) {
  return simplified(properties.inertia +
                    properties.mass * squared_distance(properties.centre - point, properties.axis));
}

}  // namespace rederive::mechanics
