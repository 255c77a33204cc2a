#include <algorithm>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <iterator>
#include <numbers>
#include <numerics/motion/batch.hpp>
#include <numerics/motion/instruction_sets.hpp>
#include <numerics/motion/kernel_start.hpp>
#include <numerics/motion/parallel.hpp>
#include <type_traits>

namespace rederive::numerics {

namespace {

using Launch = PulseBatch::Launch;

/// After an impact that leaves less than this velocity, over alpha p, a block may be about to rest.
constexpr double slow = 1e-2;
/// A push from rest that gives the block less speed than this may be none at all.
constexpr double weak_push = 1e-8;
/// So often a motion may rest or become slow.
constexpr int most_rounds = 40;

/// Motions for a kernel to follow, and whose they are.
struct Motions {
  struct Owner {
    int column, row;
    int side;       ///< on which the motion starts
    int rests = 0;  ///< so far
  };
  std::vector<Owner> owners;
  std::vector<KernelStart<double>> starts;
};

/// A motion that the pulse leaves, on the side theta > 0 of its last impact; `launch` just lifts the block
/// over the barrier from upright.
struct Left {
  const PulseCase& asked;
  double scale;
  const KernelEnd<double>& end;
  const Motions::Owner& owner;
  double launch;

  double angle() const { return end.theta / scale; }
  double velocity() const { return end.thetadot / scale; }
  Margins margins() const {
    const bool is_linear = asked.model == Model::linear;
    const double critical = is_linear ? emitted::linear_critical_velocity_positive(angle())
                                      : emitted::critical_velocity_positive(asked.block.alpha, angle());
    const double impact =
        is_linear ? emitted::linear_impact_velocity_squared_positive(angle(), velocity())
                  : emitted::impact_velocity_squared_positive(asked.block.alpha, angle(), velocity());
    return {velocity() - critical, asked.block.restitution * std::sqrt(std::max(0.0, impact)) - launch};
  }
};

/// (22), (34): what becomes of it when the pulse is over, as outcome_at_end tells it.
int code_of(const Margins& margins, int side, int impacts) {
  if (margins.outward > 0) return side * (impacts + 1);
  return margins.returning > 0 ? -side * (impacts + 2) : 0;
}

int code_after(const Left& left) {
  const int side = left.owner.side, impacts = left.end.impacts;
  switch (left.end.how) {
    case KernelEnd<double>::How::safe:
      return 0;
    case KernelEnd<double>::How::returns:
      return -side * (impacts + 2);
    case KernelEnd<double>::How::lies:
    case KernelEnd<double>::How::overturns:
      return side * (impacts + 1);
    default:
      return code_of(left.margins(), side, impacts);
  }
}

Outcome outcome_after(const Left& left) {
  const KernelEnd<double>& end = left.end;
  const int side = left.owner.side;
  const bool lies = end.how == KernelEnd<double>::How::lies;
  const Margins margins = left.margins();
  const int code = lies ? side * (end.impacts + 1) : code_of(margins, side, end.impacts);
  return {code,
          std::max(end.impacts, std::abs(code) - 1),
          left.owner.rests,
          side,
          lies,
          {margins.outward * std::exp(end.left - end.launched), margins.returning}};
}

/// Goes on after an impact that left the block slow: from the push that starts it again, if it comes to rest;
/// false if it rests for good.
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
        next.starts.emplace_back(kernel_start<double>(piece, owner.side, push->from, scale));
    restart.push = static_cast<double>(push->to - push->from);
    restart.fading = start.fading, restart.slow = slow * scale;
  } else {
    KernelStart<double>& hop = next.starts.emplace_back(kernel_start<double>(piece, owner.side, time, scale));
    hop.thetadot = end.thetadot, hop.left = end.left, hop.impacts = end.impacts;
    hop.fading = start.fading, hop.slow = end.thetadot / 4;
  }
  next.owners.push_back(owner);
  return true;
}

}  // namespace

const std::vector<BatchKernel>& batch_kernels() {
  static const std::vector<BatchKernel> all = [] {
    std::vector<BatchKernel> kernels{{"one lane", run_batch_one_lane}, {"baseline", run_batch_baseline}};
#ifdef REDERIVE_X86_KERNELS
    // x86-64-v3 and -v4. Clang 14 does not know these names; the rest of each level came with what is asked
    // here.
    const bool v3 = __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi") &&
                    __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
    const bool v4 = v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
                    __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
                    __builtin_cpu_supports("avx512vl");
    if (v3) kernels.push_back({"AVX2", run_batch_v3});
    if (v4) kernels.push_back({"AVX-512", run_batch_v4});
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
  Real start = 0;
  if (leads != 0) {
    launch.side = leads > 0 ? 1 : -1;
  } else {
    if (launch.pushes.empty()) return launch;
    const Push& first = launch.pushes.front();
    launch.side = first.side;
    start = first.from;
    launch.push = static_cast<double>(first.to - start);
    launch.gain = static_cast<double>((amplitude - upright_.level) * (first.to - start));
  }
  launch.left = static_cast<double>(launch.piece.to - start);
  launch.theta = static_cast<double>(launch.side * asked_.initial.angle * scale_);
  launch.thetadot = static_cast<double>(launch.side * asked_.initial.velocity * scale_);
  const auto pulse = kernel_start<double>(launch.piece, launch.side, start, scale_);
  launch.ground = pulse.ground, launch.quadrature = pulse.quadrature;
  launch.fading = asked_.pulse == Pulse::sine ? std::numbers::pi : 0;
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
    const Real start = launch.piece.to - static_cast<Real>(launch.left),
               end = launch.pushes.empty() ? 0 : launch.pushes.back().from;
    launch.left = static_cast<double>(end - start);
    if (!(launch.left > no_time)) launch.side = 0;
    launch.piece.to = end;
    if (!launch.pushes.empty()) launch.pushes.pop_back();
  }
  return cut;
}

template <class Result, class OfLeft>
std::vector<std::vector<Result>> PulseBatch::followed(const std::vector<double>& omega_ratios, OfLeft of_left,
                                                      Result (*of_outcome)(const Outcome&)) const {
  const double launch = asked_.model == Model::linear
                            ? emitted::linear_critical_velocity_positive(0.0)
                            : emitted::critical_velocity_positive(asked_.block.alpha, 0.0);
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
      motions.starts.push_back({.rate = omega,
                                .theta = from.theta,
                                .thetadot = from.thetadot,
                                .ground = from.ground,
                                .quadrature = from.quadrature,
                                .push = from.push / omega,
                                .left = from.left / omega,
                                .fading = from.fading / omega,
                                .slow = slow * scale_});
    }
  for (int round = 0; !motions.starts.empty(); ++round) {
    std::vector<KernelEnd<double>> ends(motions.starts.size());
    kernel_.run({asked_.model == Model::linear, scale_, asked_.block.restitution, scale_ * asked_.tolerance,
                 std::is_same_v<Result, int>},
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
      if (weak || end.how == KernelEnd<double>::How::unclear || round == most_rounds) {
        PulseCase here = asked_;
        here.omega_ratio = start.rate;
        result = of_outcome(outcome_at(here, amplitudes_[row]));
      } else if (end.how == KernelEnd<double>::How::slow) {
        if (!resume(upright_, scale_, launches_[row], end, start, owner, next))
          result = of_outcome({0, 0, owner.rests + 1});
      } else {
        result = of_left(Left{asked_, scale_, end, owner, launch});
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

/// What `follow` makes of some of the amplitudes at a time, shared among threads if there are many.
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
