// Many simulations at once, in the lanes of a vector: A. Jorba and M. Zou,
// Experimental Mathematics 14 (2005) 99-117, for the steps; each instruction set has a kernel of its own,
// chosen at run time, and all give the same motions to rounding.
#pragma once

#include <numerics/motion/overturning.hpp>
#include <vector>

namespace rederive::numerics {

/// Angles in rad, times p t, accelerations over g; in the linear model, of which alpha is the only scale,
/// angles over alpha, accelerations over alpha g.
struct BatchBlock {
  bool is_linear;
  double alpha, restitution;  ///< linear: alpha = 1
  double tolerance;           ///< of the last two terms of each series
  bool codes_only = false;    ///< a motion may end as soon as its code is certain
};

/// Where a motion starts under the pulse, on the side theta > 0: one on the other side is mirrored with its
/// ground.
struct BatchStart {
  double omega;               ///< omega_p/p
  double theta, thetadot;     ///< of the block
  double ground, quadrature;  ///< of the pulse, the latter over omega_p
  double push;                ///< from rest: how long the ground pushes at least as hard as at the start
  double left;                ///< until the pulse ends
  double fading;              ///< so long before it ends the ground keeps its sign, to come to 0 at last
  double slow;                ///< an impact that leaves less than this velocity ends the motion
  int impacts = 0;            ///< before the start
};

/// Where it ends: with the pulse, on the side theta > 0 of the last impact; lying; certain to overturn to
/// that side, to come back and overturn to the other, or never to overturn; after an impact that leaves it
/// slow; or in a graze that the kernel cannot tell from an impact.
struct BatchEnd {
  enum class How { pulse_over, lies, overturns, returns, safe, slow, unclear } how;
  double theta, thetadot, left;
  double launched;  ///< what was left when the block last started or came to upright
  int impacts;
};

/// The kernel of one instruction set.
struct BatchKernel {
  const char* name;
  void (*run)(const BatchBlock& block, const BatchStart* starts, BatchEnd* ends, int count);
};

/// Those that this processor can run, the fastest last.
const std::vector<BatchKernel>& batch_kernels();

/// One pulse at many amplitudes.
class PulseBatch {
 public:
  /// Throws std::invalid_argument like outcome_at.
  PulseBatch(const PulseCase& asked, const std::vector<double>& amplitudes,
             const BatchKernel& kernel = batch_kernels().back());

  /// For each omega_p/p outcome_at(asked, amplitude) of each amplitude. A graze is followed by outcome_at.
  std::vector<std::vector<Outcome>> outcomes(const std::vector<double>& omega_ratios) const;
  /// Their codes: each motion ends as soon as its code is certain.
  std::vector<std::vector<int>> codes(const std::vector<double>& omega_ratios) const;

  /// The same motions, until the last push of the pulse begins; one that this push starts does not start.
  PulseBatch until_last_push() const;

  /// When and with what the block starts. Times are phases: they do not depend on omega_p.
  struct Launch {
    Piece piece;                ///< the pulse
    std::vector<Push> pushes;   ///< of it
    int side = 0;               ///< 0: it does not start
    double push = 0, gain = 0;  ///< from rest: how long and, above start_level, how much the ground pushes
    double left = 0;            ///< until the pulse ends
    double fading = 0;          ///< as in BatchStart
    double theta = 0, thetadot = 0, ground = 0, quadrature = 0;  ///< mirrored to theta > 0
  };

 private:
  Launch launch_at(double amplitude) const;
  /// What is asked of each motion: of one that the pulse leaves, or of one whose outcome is known already.
  template <class Result, class OfLeft>
  std::vector<std::vector<Result>> followed(const std::vector<double>& omega_ratios, OfLeft of_left,
                                            Result (*of_outcome)(const Outcome&)) const;

  PulseCase asked_;
  double scale_;  ///< of angles and accelerations: alpha, or 1 in the linear model
  AtUpright upright_;
  std::vector<double> amplitudes_;
  BatchKernel kernel_;
  std::vector<Launch> launches_;
};

/// outcome_at of each amplitude, by the engine asked for. Several threads share them if there are many.
std::vector<Outcome> outcomes_at(const PulseCase& asked, const std::vector<double>& amplitudes,
                                 int threads = 1);

/// Impacts and rests of each amplitude before the last push of the pulse begins, followed by the kernel.
std::vector<Outcome> outcomes_before_last_push(const PulseCase& asked, const std::vector<double>& amplitudes,
                                               int threads = 1);

}  // namespace rederive::numerics
