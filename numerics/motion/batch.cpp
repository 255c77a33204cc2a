#include <algorithm>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <iterator>
#include <numbers>
#include <numerics/motion/batch.hpp>
#include <numerics/motion/kernel_arc.hpp>
#include <numerics/motion/parallel.hpp>
#include <type_traits>

namespace rederive::numerics {

namespace {

using Launch = PulseBatch::Launch;
using How = KernelEnd<double>::How;

/// After an impact that leaves less than this velocity, over alpha p, a block may be about to rest.
constexpr double slow = 1e-2;
/// A push from rest that gives the block less speed than this, over omega_p, is left to the second method:
/// rounding may hide whether it moves the block.
constexpr double weak_push = 1e-8;
/// A chain of impacts that is sure to end has fewer steps: time_of_rest takes e as 0.9999 at most.
constexpr int most_steps = 500'000;
/// The number of times that a motion may rest or become slow.
constexpr int most_rounds = 40;

/// Motions for a kernel to follow, and the cells of the result that they belong to.
struct Motions {
  struct Owner {
    int column, row;
    int side;       ///< on which the motion starts
    int rests = 0;  ///< so far
  };
  std::vector<Owner> owners;
  std::vector<KernelStart<double>> starts;
};

/// Returns the outcome of a motion that the pulse leaves, on the side theta > 0 of its last impact.
Outcome outcome_after(const PulseCase& asked, double scale, const KernelEnd<double>& end,
                      const Motions::Owner& owner) {
  return outcome_of_free_motion(asked.block, asked.model,
                                FreeMotion<double>{.side = owner.side,
                                                   .angle = end.theta / scale,
                                                   .velocity = end.thetadot / scale,
                                                   .since_launch = end.launched - end.left,
                                                   .impacts = end.impacts,
                                                   .rests = owner.rests,
                                                   .lies = end.how == How::lies});
}

/// Returns the code of this outcome, which the kernel may have found already.
int code_after(const PulseCase& asked, double scale, const KernelEnd<double>& end,
               const Motions::Owner& owner) {
  if (end.how == How::safe) return 0;
  if (end.how == How::returns) return -owner.side * (end.impacts + 2);
  if (end.how == How::overturns || end.how == How::lies) return owner.side * (end.impacts + 1);
  return outcome_after(asked, scale, end, owner).code;
}

/// Adds to `next` how a motion goes on after an impact that leaves the block slow: it hops on, or rests until
/// a push starts it again. Returns false if it rests for good.
bool resume(const AtUpright& upright, double scale, const Launch& from, const KernelEnd<double>& end,
            const KernelStart<double>& start, Motions::Owner owner, Motions& next) {
  Piece piece = from.piece;
  piece.omega = start.rate, piece.to /= start.rate;
  const Real time = piece.to - end.left, velocity = owner.side * end.thetadot / scale;
  if (const auto rest = time_of_rest(upright, piece, {time, 0, velocity})) {
    std::vector<Push> pushes = from.pushes;
    for (Push& push : pushes) push.from /= start.rate, push.to /= start.rate;
    const auto push = push_that_starts(pushes, upright.level, piece, *rest);
    if (!push) return false;
    owner.side = push->side, ++owner.rests;
    KernelStart<double>& restart =
        next.starts.emplace_back(kernel_start<double>(piece, owner.side, {push->from}, scale));
    restart.push = static_cast<double>(push->to - push->from);
    restart.fading = start.fading, restart.slow = slow * scale;
  } else {
    KernelStart<double>& hop =
        next.starts.emplace_back(kernel_start<double>(piece, owner.side, {time}, scale));
    hop.thetadot = end.thetadot, hop.left = end.left, hop.impacts = end.impacts;
    hop.fading = start.fading, hop.slow = end.thetadot / 4;
  }
  next.owners.push_back(owner);
  return true;
}

}  // namespace

const std::vector<BatchKernel>& batch_kernels() {
  static const std::vector<BatchKernel> all = [] {
    std::vector<BatchKernel> kernels{{"one lane", run_batch<InstructionSet::one_lane>},
                                     {"baseline", run_batch<InstructionSet::baseline>}};
#ifdef REDERIVE_X86_KERNELS
    // x86-64-v3 and -v4. Clang 14 does not know these names; the rest of each level came with what is asked
    // here.
    const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
                    __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
    const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
    if (v3) kernels.push_back({"AVX2", run_batch<InstructionSet::v3>});
    if (v4) kernels.push_back({"AVX-512", run_batch<InstructionSet::v4>});
#endif
    return kernels;
  }();
  return all;
}

PulseBatch::Launch PulseBatch::launch_at(double amplitude) const {
  Launch launch;
  const Real leads = asked_.initial.angle != 0 ? asked_.initial.angle : asked_.initial.velocity;
  if (leads == 0 && amplitude >= 0 && amplitude < upright_.level) return launch;
  launch.piece = pulse_motion(asked_.pulse, 1, amplitude, upright_.level).front();
  launch.pushes = pushes(launch.piece, upright_.level);
  Real start = 0, push = 0;
  if (leads != 0) {
    launch.side = leads > 0 ? 1 : -1;
  } else {
    if (launch.pushes.empty()) return launch;
    const Push& first = launch.pushes.front();
    launch.side = first.side;
    start = first.from;
    push = first.to - start;
    launch.gain = static_cast<double>((amplitude - upright_.level) * push);
  }
  launch.start = kernel_start<double>(launch.piece, launch.side,
                                      {start, asked_.initial.angle, asked_.initial.velocity}, scale_);
  launch.start.push = static_cast<double>(push);
  launch.start.fading = asked_.pulse == Pulse::sine ? std::numbers::pi : 0;
  launch.start.slow = slow * scale_;
  return launch;
}

PulseBatch::PulseBatch(const PulseCase& asked, const std::vector<double>& amplitudes,
                       const BatchKernel& kernel)
    : asked_(asked),
      scale_(kernel_scale(asked.block, asked.model)),
      upright_(at_upright(asked.block, asked.model)),
      amplitudes_(amplitudes),
      kernel_(kernel) {
  launches_.reserve(amplitudes.size());
  for (const double amplitude : amplitudes) launches_.push_back(launch_at(amplitude));
}

PulseBatch PulseBatch::until_last_push() const {
  constexpr double no_time = 1e-9;  // of the phase
  PulseBatch cut = *this;
  for (Launch& launch : cut.launches_) {
    const Real start = launch.piece.to - static_cast<Real>(launch.start.left),
               end = launch.pushes.empty() ? 0 : launch.pushes.back().from;
    launch.start.left = static_cast<double>(end - start);
    if (!(launch.start.left > no_time)) launch.side = 0;
    launch.piece.to = end;
    if (!launch.pushes.empty()) launch.pushes.pop_back();
  }
  return cut;
}

template <class Result, class OfLeft>
std::vector<std::vector<Result>> PulseBatch::followed(const std::vector<double>& omega_ratios, OfLeft of_left,
                                                      Result (*of_outcome)(const Outcome&)) const {
  std::vector<std::vector<Result>> all(omega_ratios.size(), std::vector<Result>(amplitudes_.size()));
  Motions motions;
  motions.owners.reserve(omega_ratios.size() * amplitudes_.size());
  motions.starts.reserve(omega_ratios.size() * amplitudes_.size());
  for (int column = 0; column < std::ssize(omega_ratios); ++column)
    for (int row = 0; row < std::ssize(launches_); ++row) {
      const Launch& from = launches_[static_cast<std::size_t>(row)];
      const double omega = omega_ratios[static_cast<std::size_t>(column)];
      if (from.side == 0) continue;
      motions.owners.push_back({column, row, from.side});
      KernelStart<double>& start = motions.starts.emplace_back(from.start);
      start.rate = omega;
      for (double* time : {&start.push, &start.left, &start.fading}) *time /= omega;
    }
  for (int round = 0; !motions.starts.empty(); ++round) {
    std::vector<KernelEnd<double>> ends(motions.starts.size());
    kernel_.run({.is_linear = asked_.model == Model::linear,
                 .alpha = scale_,
                 .restitution = asked_.block.restitution,
                 .tolerance = scale_ * asked_.tolerance,
                 .codes_only = std::is_same_v<Result, int>,
                 .most_steps = most_steps},
                motions.starts.data(), ends.data(), static_cast<int>(ends.size()));
    Motions next;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const KernelEnd<double>& end = ends[k];
      const KernelStart<double>& start = motions.starts[k];
      Motions::Owner owner = motions.owners[k];
      const auto row = static_cast<std::size_t>(owner.row);
      Result& result = all[static_cast<std::size_t>(owner.column)][row];
      if ((end.impacts - start.impacts) % 2 != 0) owner.side = -owner.side;
      const bool weak = round == 0 && start.push > 0 && launches_[row].gain < weak_push * start.rate;
      if (weak || end.how == How::unclear || round == most_rounds) {
        PulseCase here = asked_;
        here.omega_ratio = start.rate;
        result = of_outcome(outcome_at(here, amplitudes_[row]));
      } else if (end.how == How::slow) {
        if (!resume(upright_, scale_, launches_[row], end, start, owner, next))
          result = of_outcome({0, 0, owner.rests + 1});
      } else {
        result = of_left(asked_, scale_, end, owner);
      }
    }
    motions = std::move(next);
  }
  return all;
}

std::vector<std::vector<Outcome>> PulseBatch::outcomes(const std::vector<double>& omega_ratios) const {
  return followed<Outcome>(
      omega_ratios, outcome_after, +[](const Outcome& outcome) { return outcome; });
}

std::vector<std::vector<int>> PulseBatch::codes(const std::vector<double>& omega_ratios) const {
  return followed<int>(
      omega_ratios, code_after, +[](const Outcome& outcome) { return outcome.code; });
}

namespace {

/// Returns what `follow` returns for some of the amplitudes at a time, shared among threads if there are
/// many.
template <class Follow>
std::vector<Outcome> shared_outcomes(const std::vector<double>& amplitudes, int threads,
                                     const Follow& follow) {
  constexpr int worth_a_thread = 64;
  const std::ptrdiff_t count = std::ssize(amplitudes);
  Work work;
  work.threads = threads;
  work.count = threads == 1 ? 1 : std::max(static_cast<int>(count / worth_a_thread), 1);
  std::vector<Outcome> all(amplitudes.size());
  for_each_index(work, [&](int i) {
    const auto from = amplitudes.begin() + count * i / work.count,
               to = amplitudes.begin() + count * (i + 1) / work.count;
    std::ranges::copy(follow(std::vector(from, to)), all.begin() + count * i / work.count);
  });
  return all;
}

}  // namespace

std::vector<Outcome> outcomes_at(const PulseCase& asked, const std::vector<double>& amplitudes, int threads) {
  return shared_outcomes(amplitudes, threads, [&](const std::vector<double>& some) {
    if (asked.engine == Engine::taylor) return PulseBatch(asked, some).outcomes({asked.omega_ratio}).front();
    std::vector<Outcome> found;
    for (const double amplitude : some) found.push_back(outcome_at(asked, amplitude));
    return found;
  });
}

std::vector<Outcome> outcomes_before_last_push(const PulseCase& asked, const std::vector<double>& amplitudes,
                                               int threads) {
  return shared_outcomes(amplitudes, threads, [&](const std::vector<double>& some) {
    return PulseBatch(asked, some).until_last_push().outcomes({asked.omega_ratio}).front();
  });
}

}  // namespace rederive::numerics
