// Many motions at once, in the lanes of vectors. The kernel is compiled for several instruction sets, one of
// which is chosen at run time; all give the same motions, up to rounding.
#pragma once

#include <numerics/motion/kernel_case.hpp>
#include <numerics/motion/overturning.hpp>
#include <numerics/motion/rest.hpp>
#include <vector>

namespace rederive::numerics {

/// The kernel of one instruction set.
struct BatchKernel {
  const char* name;
  void (*run)(const KernelBlock<double>& block, const KernelStart<double>* starts, KernelEnd<double>* ends,
              int count);
};

/// Returns the kernels that this processor can run, the fastest last.
const std::vector<BatchKernel>& batch_kernels();

/// One pulse at many amplitudes.
class PulseBatch {
 public:
  /// Throws std::invalid_argument like outcome_at.
  PulseBatch(const PulseCase& asked, const std::vector<double>& amplitudes,
             const BatchKernel& kernel = batch_kernels().back());

  /// Returns, for each omega_p/p, the outcome of each amplitude. A graze is followed by outcome_at.
  std::vector<std::vector<Outcome>> outcomes(const std::vector<double>& omega_ratios) const;
  /// Returns the codes of these outcomes: each motion ends as soon as its code is certain.
  std::vector<std::vector<int>> codes(const std::vector<double>& omega_ratios) const;

  /// Returns the same motions, stopped when the last push of the pulse begins. A motion that this push would
  /// start does not start.
  PulseBatch until_last_push() const;

  /// When and with what the block starts. Times are phases: they do not depend on omega_p.
  struct Launch {
    Piece piece;               ///< the pulse
    std::vector<Push> pushes;  ///< of the pulse
    int side = 0;              ///< 0: it does not start
    double gain = 0;  ///< from rest: how much, integrated over the first push, the ground exceeds start_level
    KernelStart<double> start;  ///< with omega_p = p
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

/// Returns the outcome of each amplitude by the engine of `asked`. Several threads share them if there are
/// many. Throws std::invalid_argument like outcome_at.
std::vector<Outcome> outcomes_at(const PulseCase& asked, const std::vector<double>& amplitudes,
                                 int threads = 1);

/// Returns impacts and rests of each amplitude before the last push of the pulse begins, by the kernel.
std::vector<Outcome> outcomes_before_last_push(const PulseCase& asked, const std::vector<double>& amplitudes,
                                               int threads = 1);

}  // namespace rederive::numerics
