// The block, and the two models of its motion: G. W. Housner, The behavior of inverted pendulum structures
// during earthquakes, Bull. Seism. Soc. Am. 53 (1963) 403-417.
#pragma once

#include <optional>

namespace rederive::numerics {

/// The acceleration of gravity in m/s^2, which converts lengths and accelerations in SI units.
inline constexpr double standard_gravity = 9.81;

/// The scalar of times, phases and states: the widest type of the machine. Results are given in double.
using Real = long double;

/// The equations of motion: (56a,b), or (21a,b).
enum class Model { linear, nonlinear };

/// A free-standing rectangular block: alpha = atan(b/h) in rad, p = sqrt(3g/4R) in 1/s, and the ratio of the
/// angular velocities after and before an impact, eq (34).
struct Block {
  double alpha = 0.25;
  double p = 2.14;
  double restitution = 1;
};

/// Returns a block with 1e-12 <= alpha < pi/2 in rad, p > 0 in 1/s and 0 < restitution <= 1; without a
/// restitution, that of eq (46). Throws std::invalid_argument that names the value out of range.
Block make_block(double alpha, double p, std::optional<double> restitution = {});

/// Returns the block with half width b and half height h in metres, both above 0, under gravity g in m/s^2.
/// Throws as make_block does.
Block block_from_size(double half_width, double half_height, std::optional<double> restitution = {},
                      double gravity = standard_gravity);

/// Returns |u_gddot|/(alpha g) at which a block at rest starts to rock: 1 (linear) or tan(alpha)/alpha,
/// eq (24).
Real start_level(const Block& block, Model model);

/// Where and how the block moves: tau = p t, theta/alpha, thetadot/(alpha p).
struct Point {
  Real time = 0;
  Real angle = 0;
  Real velocity = 0;
};

/// Returns thetaddot/(alpha p^2) on one side (-1: theta < 0, +1: theta > 0), at theta/alpha = `angle` and
/// under `ground` = u_gddot/(alpha g), by (21a,b) or, in the linear model, by (56a,b).
Real acceleration(const Block& block, Model model, int side, Real angle, Real ground);

}  // namespace rederive::numerics
