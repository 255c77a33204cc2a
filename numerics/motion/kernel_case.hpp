// What the kernel of the motion is given, and what it returns; T is the scalar of its lanes.
//
// Angles are in rad, times p t, accelerations over g; in the linear model, of which alpha is the only scale,
// angles are over alpha and accelerations over alpha g.
#pragma once

namespace rederive::numerics {

/// The block, and how closely its motion is followed.
template <class T>
struct KernelBlock {
  bool is_linear;
  T alpha, restitution;     ///< in the linear model alpha = 1
  T tolerance;              ///< of the last two terms of each series
  bool codes_only = false;  ///< whether a motion may end as soon as its code is certain
  int most_steps = 10'000;  ///< after which a motion is unclear
};

/// The start of a motion on one smooth piece of ground motion, on the side theta > 0: a motion on the other
/// side is mirrored with its ground.
template <class T>
struct KernelStart {
  T rate = 0;                 ///< omega_p/p of a pulse; rate of the ground acceleration of a straight line
  T theta = 0, thetadot = 0;  ///< of the block
  T ground = 0;               ///< acceleration of the ground
  T quadrature = 0;           ///< of a pulse: rate of the ground acceleration over omega_p
  T push = 0;                 ///< from rest: how long the ground pushes at least as hard as at the start
  T left = 0;                 ///< until the piece ends
  T fading = 0;     ///< for this long before the pulse ends, the ground keeps its sign and fades to 0
  T slow = 0;       ///< an impact that leaves less than this velocity ends the motion
  int impacts = 0;  ///< before the start
};

/// The end of a motion, on the side theta > 0 of the last impact.
template <class T>
struct KernelEnd {
  enum class How {
    pulse_over,  ///< with the piece of ground motion
    lies,        ///< theta = pi/2, nonlinear
    overturns,   ///< certain to overturn to this side
    returns,     ///< certain to come back and overturn to the other side
    safe,        ///< certain never to overturn
    slow,        ///< after an impact that leaves it slow
    unclear      ///< in a graze that the kernel cannot tell from an impact, or after too many steps
  };
  How how;
  T theta, thetadot, left;
  T launched;  ///< what was left when the block last started or came to upright
  int impacts;
};

/// What the kernel of many motions is compiled for. v3 and v4 are the levels x86-64-v3 (AVX2) and x86-64-v4
/// (AVX-512).
enum class InstructionSet { one_lane, baseline, v3, v4 };

/// Follows `count` motions under pulses from `starts` to `ends`.
template <InstructionSet set>
void run_batch(const KernelBlock<double>& block, const KernelStart<double>* starts, KernelEnd<double>* ends,
               int count);

}  // namespace rederive::numerics
