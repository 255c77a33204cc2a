#include <numerics/overturning.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rederive::inline numeric {
namespace {

/// Equations (62), (63): (theta -+ alpha)^2 - thetadot^2 is constant, and theta = alpha is approached along
/// thetadot + p (theta -+ alpha) = 0, (68), (75).
Margins linear_margins(Real y, Real u, Real e) {
  const Real outward = u + (y - 1);
  const Real impact_squared = 1 + outward * (u - (y - 1));
  return {outward, e * std::sqrt(std::max<Real>(0, impact_squared)) - 1};
}

/// The energies (22) with p = 1, E/(m g R) = thetadot^2/2 + cos(alpha - |theta|) - cos(alpha), their
/// differences of cosines written as products: so nothing cancels for slender blocks or near theta = alpha.
Margins nonlinear_margins(Real alpha, Real y, Real u, Real e) {
  const Real climb = 2 * std::sin(alpha * (1 - y) / 2) / alpha;  // to theta = alpha; < 0 beyond it
  const Real height = 2 * (std::sin(alpha * (2 - y) / 2) / alpha) * (std::sin(alpha * y / 2) / alpha);
  const Real impact = std::sqrt(std::max<Real>(0, u * u + 2 * height));
  const Real launch = 2 * std::sin(alpha / 2) / alpha;
  return {u - climb, e * impact - launch};
}

}  // namespace

Margins free_motion_margins(const Block& block, Model model, int side, const Point& at) {
  const Real y = side * at.angle, u = side * at.velocity;
  return model == Model::linear ? linear_margins(y, u, block.restitution)
                                : nonlinear_margins(block.alpha, y, u, block.restitution);
}

Outcome outcome_at_end(const Block& block, Model model, const Response& response) {
  Outcome outcome;
  outcome.impacts = response.impacts;
  outcome.rests = response.rests;
  outcome.side = response.side;
  outcome.lies = response.lies;
  if (response.side == 0) return outcome;
  Margins margins = free_motion_margins(block, model, response.side, response.end);
  if (response.lies || margins.outward > 0) {
    outcome.code = response.side * (response.impacts + 1);
  } else if (margins.returning > 0) {
    outcome.impacts = response.impacts + 1;
    outcome.code = -response.side * (outcome.impacts + 1);
  }
  margins.outward *= std::exp(response.last_launch - response.end.time);
  outcome.margins = margins;
  return outcome;
}

Outcome outcome_of(const Block& block, Model model, const GroundMotion& motion, const InitialState& initial,
                   double tolerance) {
  ResponseOptions options;
  options.tolerance = tolerance;
  return outcome_at_end(block, model, respond(block, model, motion, initial, options));
}

Outcome outcome_at(const PulseCase& asked, Real amplitude) {
  const Real level = start_level(asked.block, asked.model);
  const bool rests = asked.initial.angle == 0 && asked.initial.velocity == 0;
  if (rests && amplitude < level && amplitude >= 0) return {};
  const GroundMotion motion = pulse_motion(asked.pulse, asked.omega_ratio, amplitude, level);
  return outcome_of(asked.block, asked.model, motion, asked.initial, asked.tolerance);
}

}  // namespace rederive::numeric
