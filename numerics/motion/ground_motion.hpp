// Ground accelerations of smooth pieces, and the one-sine and one-cosine pulses made of one; in units of
// alpha g against tau = p t.
#pragma once

#include <numerics/motion/block.hpp>
#include <vector>

namespace rederive::numerics {

enum class Pulse { sine, cosine };

/// One smooth stretch of ground acceleration, from <= tau <= to: the line value + slope (tau - from), or the
/// sine amplitude sin(omega (tau - from) + phase), then without a line.
struct Piece {
  Real from = 0, to = 0;
  Real value = 0, slope = 0;
  Real amplitude = 0, omega = 1, phase = 0;
};

/// Stretches one after the other from tau = 0; the ground is still after the last.
using GroundMotion = std::vector<Piece>;

/// Returns the pulse from the instant at which rocking can start, with omega_p/p = `omega_ratio` > 0 and
/// a_p/(alpha g) = `amplitude` >= `level` = start_level:
/// sine a sin(w tau + psi) with a sin(psi) = level until tau = (2 pi - psi)/w, eq (52);
/// cosine a cos(w tau + psi) with a cos(psi) = level until tau = (3 pi/2 - psi)/w, section 3.
/// Throws std::invalid_argument for values out of range.
GroundMotion pulse_motion(Pulse pulse, Real omega_ratio, Real amplitude, Real level);

/// Return the phase psi of that pulse, in rad, and the time tau at which it ends.
Real pulse_phase(Pulse pulse, Real amplitude, Real level);
Real pulse_end(Pulse pulse, Real omega_ratio, Real psi);

/// Returns the ground acceleration in units of alpha g at a time in the piece.
Real ground_at(const Piece& piece, Real time);

struct Range {
  Real low, high;
};
/// Returns bounds of the ground acceleration over [from, to] inside the piece.
Range ground_range(const Piece& piece, Real from, Real to);
/// Returns the greatest size of the ground acceleration over [from, to] inside the piece, in double
/// precision.
double most_ground(const Piece& piece, Real from, Real to);

/// A stretch of time in which |ground| is above the level, and the side to which it drives the block.
struct Push {
  Real from, to;
  int side;
};
/// Returns the pushes in the piece above `level`, in order: a positive ground acceleration drives the block
/// to theta < 0.
std::vector<Push> pushes(const Piece& piece, Real level);

}  // namespace rederive::numerics
