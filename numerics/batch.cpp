#include <algorithm>
#include <cmath>
#include <emitted/rocking_block.hpp>
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
/// So often a motion may rest or become slow.
constexpr int most_rounds = 40;

/// A motion that a kernel is to follow.
struct Pending {
  std::size_t cell;
  int side;  ///< on which it starts
  BatchStart start;
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

/// Goes on after an impact that left the block slow: from the push that starts it again, if it comes to rest;
/// nothing if it rests for good.
std::optional<Pending> resumed(const Block& block, Piece piece, const Pending& from, const BatchEnd& end,
                               int side) {
  Pending next = from;
  const Real time = piece.to - end.left, velocity = side * end.thetadot / block.alpha;
  if (const auto rest = time_of_rest(block, Model::nonlinear, piece, {time, 0, velocity})) {
    const auto push = push_that_starts(block, Model::nonlinear, piece, *rest);
    if (!push) return std::nullopt;
    const Mirrored pulse = mirrored(block, piece, push->side, push->from);
    next.side = push->side;
    next.start = {from.start.omega,
                  0,
                  0,
                  pulse.ground,
                  pulse.quadrature,
                  static_cast<double>(push->to - push->from),
                  static_cast<double>(piece.to - push->from),
                  slow * block.alpha};
  } else {
    const Mirrored pulse = mirrored(block, piece, side, time);
    next.side = side;
    next.start = {from.start.omega, 0,          end.thetadot, pulse.ground, pulse.quadrature, 0, end.left,
                  end.thetadot / 4, end.impacts};
  }
  return next;
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

std::vector<int> PulseBatch::codes(double omega_ratio) const {
  const Block& block = asked_.block;
  std::vector<int> codes(amplitudes_.size(), 0);
  std::vector<Pending> pending;
  for (std::size_t i = 0; i < launches_.size(); ++i) {
    const Launch& from = launches_[i];
    if (from.side != 0)
      pending.push_back({i,
                         from.side,
                         {omega_ratio, from.theta, from.thetadot, from.ground, from.quadrature,
                          from.push / omega_ratio, from.left / omega_ratio, slow * block.alpha}});
  }
  for (int round = 0; !pending.empty(); ++round) {
    std::vector<BatchStart> starts;
    for (const Pending& motion : pending) starts.push_back(motion.start);
    std::vector<BatchEnd> ends(starts.size());
    kernel_.run({block.alpha, block.restitution, block.alpha * asked_.tolerance}, starts.data(), ends.data(),
                static_cast<int>(starts.size()));
    std::vector<Pending> next;
    for (std::size_t k = 0; k < pending.size(); ++k) {
      const BatchEnd& end = ends[k];
      const std::size_t cell = pending[k].cell;
      const int side = (end.impacts - starts[k].impacts) % 2 == 0 ? pending[k].side : -pending[k].side;
      const bool weak = round == 0 && launches_[cell].push > 0 && launches_[cell].gain < 1e-8 * omega_ratio;
      if (weak || end.how == BatchEnd::How::unclear || round == most_rounds) {
        PulseCase here = asked_;
        here.omega_ratio = omega_ratio;
        codes[cell] = outcome_at(here, amplitudes_[cell]).code;
      } else if (end.how == BatchEnd::How::slow) {
        Piece piece = launches_[cell].piece;
        piece.omega = omega_ratio, piece.to /= omega_ratio;
        if (const auto more = resumed(block, piece, pending[k], end, side)) next.push_back(*more);
      } else {
        codes[cell] = code_of(block, end, side);
      }
    }
    pending = std::move(next);
  }
  return codes;
}

}  // namespace numeric
}  // namespace rederive
