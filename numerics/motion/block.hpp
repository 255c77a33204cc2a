// The block, and the two models of its motion: G. W. Housner, The behavior of inverted pendulum structures
// during earthquakes, Bull. Seism. Soc. Am. 53 (1963) 403-417.
#pragma once

#include <optional>

namespace rederive::numerics {

/// g in m/s^2, where a length or an acceleration is given in SI units.
inline constexpr double standard_gravity = 9.81;

/// Times, phases and states are carried in the widest type of the machine; results are given in double.
using Real = long double;

/// linear: equations (56a,b), exact arcs. nonlinear: equations (21a,b), integrated.
enum class Model { linear, nonlinear };

/// A free-standing rectangular block: alpha = atan(b/h) in rad, p = sqrt(3g/4R) in 1/s, and the ratio of the
/// angular velocities after and before an impact, eq (34).
struct Block {
  double alpha = 0.25;
  double p = 2.14;
  double restitution = 1;
};

/// 1e-12 <= alpha < pi/2, p > 0, 0 < restitution <= 1; without a restitution that of eq (46) is taken.
/// Throws std::invalid_argument naming the value that is out of range.
Block make_block(double alpha, double p, std::optional<double> restitution = {});

/// The same from half width b and half height h in metres, under gravity g in m/s^2.
Block block_from_size(double half_width, double half_height, std::optional<double> restitution = {},
                      double gravity = standard_gravity);

/// |u_gddot|/(alpha g) at which a block at rest starts to rock: 1 (linear) or tan(alpha)/alpha, eq (24).
Real start_level(const Block& block, Model model);

/// Where and how the block moves: tau = p t, theta/alpha, thetadot/(alpha p).
struct Point {
  Real time = 0;
  Real angle = 0;
  Real velocity = 0;
};

/// thetaddot/(alpha p^2) on one side (-1: theta<0, +1: theta>0) under `ground` = u_gddot/(alpha g), of
/// (21a,b) or, for the linear model, of (56a,b).
Real acceleration(const Block& block, Model model, int side, Real angle, Real ground);

}  // namespace rederive::numerics
