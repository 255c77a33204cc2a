// Where a motion starts, in the terms of the kernel; and one motion by the kernel, arc after arc.
#pragma once

#include <emitted/rocking_block.hpp>
#include <numerics/motion/arc.hpp>
#include <numerics/motion/kernel_case.hpp>

namespace rederive::numerics {

/// The unit of the kernel's angles and accelerations, in alpha: alpha, or 1 in the linear model.
inline double kernel_scale(const Block& block, Model model) {
  return model == Model::linear ? 1 : block.alpha;
}

/// Returns whether the kernel takes the ground motion of the piece as a straight line. It takes everything
/// else as a pulse, ground at rest as a pulse of amplitude 0.
inline bool is_line(const Piece& piece) { return piece.value != 0 || piece.slope != 0; }

/// Returns the start of a motion from the state `at` on `side` in the piece, under the ground there; `scale`
/// is kernel_scale.
template <class T>
KernelStart<T> kernel_start(const Piece& piece, int side, const Point& at, double scale) {
  KernelStart<T> start{.theta = static_cast<T>(side * scale * at.angle),
                       .thetadot = static_cast<T>(side * scale * at.velocity),
                       .left = static_cast<T>(piece.to - at.time)};
  const Real since = at.time - piece.from;
  if (!is_line(piece)) {
    const T amplitude = side * scale * static_cast<T>(piece.amplitude),
            phase = static_cast<T>(piece.omega * since + piece.phase), zero = 0;
    start.rate = static_cast<T>(piece.omega);
    start.ground = emitted::ground_of_sine_pulse(amplitude, zero, phase, zero);
    start.quadrature = emitted::quadrature_of_sine_pulse(amplitude, zero, phase, zero);
  } else {
    start.rate = static_cast<T>(side * scale * piece.slope);
    start.ground = static_cast<T>(side * scale * (piece.value + piece.slope * since));
  }
  return start;
}

/// Returns what follows a block by the kernel, with errors of the size of rounding. Where rounding hides
/// whether a graze is an impact, the second method follows the arc (reference_follower).
Follow kernel_follower(const Block& block, Model model, const ResponseOptions& options);

}  // namespace rederive::numerics
