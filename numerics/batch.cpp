#include <algorithm>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <iterator>
#include <numerics/batch.hpp>

namespace rederive {

using RunBatch = void(const BatchBlock&, const BatchStart*, BatchEnd*, int);
RunBatch run_batch_one_lane, run_batch_baseline, run_batch_v3, run_batch_v4;

inline namespace numeric {
namespace {

using Launch = PulseBatch::Launch;

/// The pulse at a time, mirrored to the side theta > 0, over g.
struct Mirrored {
  double ground, quadrature;
};
Mirrored mirrored(const Block& block, const Piece& piece, int side, Real time) {
  const Real amplitude = side * block.alpha * piece.amplitude;
  return {static_cast<double>(emitted::ground_of_sine_pulse(amplitude, piece.omega, piece.phase, time)),
          static_cast<double>(emitted::quadrature_of_sine_pulse(amplitude, piece.omega, piece.phase, time))};
}

Launch launch_at(const PulseCase& asked, double amplitude) {
  Launch launch;
  const Real level = start_level(asked.block, Model::nonlinear), alpha = asked.block.alpha;
  const Real leads = asked.initial.angle != 0 ? asked.initial.angle : asked.initial.velocity;
  if (leads == 0 && amplitude >= 0 && amplitude < level) return launch;
  launch.piece = pulse_motion(asked.pulse, 1, amplitude, level).front();
  Real start = 0;
  if (leads != 0) {
    launch.side = leads > 0 ? 1 : -1;
  } else {
    const std::vector<Push> all = pushes(launch.piece, level);
    if (all.empty()) return launch;
    launch.side = all.front().side;
    start = all.front().from;
    launch.push = static_cast<double>(all.front().to - start);
    launch.gain = static_cast<double>((amplitude - level) * (all.front().to - start));
  }
  launch.left = static_cast<double>(launch.piece.to - start);
  launch.theta = static_cast<double>(launch.side * asked.initial.angle * alpha);
  launch.thetadot = static_cast<double>(launch.side * asked.initial.velocity * alpha);
  const Mirrored pulse = mirrored(asked.block, launch.piece, launch.side, start);
  launch.ground = pulse.ground, launch.quadrature = pulse.quadrature;
  return launch;
}

/// After an impact that leaves less than this velocity, over alpha p, a block may be about to rest.
constexpr double slow = 1e-3;
/// A push from rest that gives the block less speed than this may be none at all.
constexpr double weak_push = 1e-8;
/// So often a motion may rest or become slow.
constexpr int most_rounds = 40;

/// Motions for a kernel to follow, and whose they are.
struct Motions {
  struct Owner {
    int column, row;
    int side;  ///< on which the motion starts
  };
  std::vector<Owner> owners;
  std::vector<BatchStart> starts;
};

/// (22), (34): the code of a motion that the pulse leaves on the side theta > 0 of its last impact.
int code_of(const Block& block, const BatchEnd& end, int side) {
  if (end.how == BatchEnd::How::lies) return side * (end.impacts + 1);
  const double alpha = block.alpha, angle = end.theta / alpha, velocity = end.thetadot / alpha;
  if (velocity > emitted::critical_velocity_positive(alpha, angle)) return side * (end.impacts + 1);
  const double impact = emitted::impact_velocity_squared_positive(alpha, angle, velocity),
               launch = emitted::critical_velocity_positive(alpha, 0.0);
  const bool returns = block.restitution * std::sqrt(std::max(0.0, impact)) > launch;
  return returns ? -side * (end.impacts + 2) : 0;
}

/// Goes on after an impact that left the block slow, on `side`: from the push that starts it again, if it
/// comes to rest; not at all if it rests for good.
void resume(const Block& block, const Piece& piece, const BatchEnd& end, Motions::Owner owner,
            Motions& next) {
  const Real time = piece.to - end.left, velocity = owner.side * end.thetadot / block.alpha;
  const auto omega = static_cast<double>(piece.omega);
  if (const auto rest = time_of_rest(block, Model::nonlinear, piece, {time, 0, velocity})) {
    const auto push = push_that_starts(block, Model::nonlinear, piece, *rest);
    if (!push) return;
    owner.side = push->side;
    const Mirrored pulse = mirrored(block, piece, owner.side, push->from);
    next.starts.push_back({omega, 0, 0, pulse.ground, pulse.quadrature,
                           static_cast<double>(push->to - push->from),
                           static_cast<double>(piece.to - push->from), slow * block.alpha});
  } else {
    const Mirrored pulse = mirrored(block, piece, owner.side, time);
    next.starts.push_back(
        {omega, 0, end.thetadot, pulse.ground, pulse.quadrature, 0, end.left, end.thetadot / 4, end.impacts});
  }
  next.owners.push_back(owner);
}

}  // namespace

const std::vector<BatchKernel>& batch_kernels() {
  static const std::vector<BatchKernel> all = [] {
    std::vector<BatchKernel> kernels{{"one lane", run_batch_one_lane}, {"baseline", run_batch_baseline}};
#ifdef REDERIVE_X86_KERNELS
    if (__builtin_cpu_supports("x86-64-v3")) kernels.push_back({"AVX2", run_batch_v3});
    if (__builtin_cpu_supports("x86-64-v4")) kernels.push_back({"AVX-512", run_batch_v4});
#endif
    return kernels;
  }();
  return all;
}

PulseBatch::PulseBatch(const PulseCase& asked, const std::vector<double>& amplitudes,
                       const BatchKernel& kernel)
    : asked_(asked), amplitudes_(amplitudes), kernel_(kernel) {
  for (const double amplitude : amplitudes) launches_.push_back(launch_at(asked, amplitude));
}

std::vector<std::vector<int>> PulseBatch::codes(const std::vector<double>& omega_ratios) const {
  const Block& block = asked_.block;
  std::vector<std::vector<int>> codes(omega_ratios.size(), std::vector<int>(amplitudes_.size(), 0));
  Motions motions;
  motions.owners.reserve(omega_ratios.size() * amplitudes_.size());
  motions.starts.reserve(omega_ratios.size() * amplitudes_.size());
  for (int column = 0; column < std::ssize(omega_ratios); ++column)
    for (int row = 0; row < std::ssize(launches_); ++row) {
      const Launch& from = launches_[static_cast<std::size_t>(row)];
      const double omega = omega_ratios[static_cast<std::size_t>(column)];
      if (from.side == 0) continue;
      motions.owners.push_back({column, row, from.side});
      motions.starts.push_back({omega, from.theta, from.thetadot, from.ground, from.quadrature,
                                from.push / omega, from.left / omega, slow * block.alpha});
    }
  for (int round = 0; !motions.starts.empty(); ++round) {
    std::vector<BatchEnd> ends(motions.starts.size());
    kernel_.run({block.alpha, block.restitution, block.alpha * asked_.tolerance}, motions.starts.data(),
                ends.data(), static_cast<int>(ends.size()));
    Motions next;
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const BatchEnd& end = ends[k];
      const BatchStart& start = motions.starts[k];
      Motions::Owner owner = motions.owners[k];
      const auto row = static_cast<std::size_t>(owner.row);
      int& code = codes[static_cast<std::size_t>(owner.column)][row];
      if ((end.impacts - start.impacts) % 2 != 0) owner.side = -owner.side;
      const bool weak = round == 0 && start.push > 0 && launches_[row].gain < weak_push * start.omega;
      if (weak || end.how == BatchEnd::How::unclear || round == most_rounds) {
        PulseCase here = asked_;
        here.omega_ratio = start.omega;
        code = outcome_at(here, amplitudes_[row]).code;
      } else if (end.how == BatchEnd::How::slow) {
        Piece piece = launches_[row].piece;
        piece.omega = start.omega, piece.to /= start.omega;
        resume(block, piece, end, owner, next);
      } else {
        code = code_of(block, end, owner.side);
      }
    }
    motions = std::move(next);
  }
  return codes;
}

}  // namespace numeric
}  // namespace rederive
