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

Launch launch_at(const PulseCase& asked, double amplitude) {
  Launch launch;
  const Real level = start_level(asked.block, Model::nonlinear), alpha = asked.block.alpha;
  const Real leads = asked.initial.angle != 0 ? asked.initial.angle : asked.initial.velocity;
  if (leads == 0 && amplitude >= 0 && amplitude < level) return launch;
  const Piece piece = pulse_motion(asked.pulse, 1, amplitude, level).front();
  Real start = 0;
  if (leads != 0) {
    launch.side = leads > 0 ? 1 : -1;
  } else {
    const std::vector<Push> all = pushes(piece, level);
    if (all.empty()) return launch;
    launch.side = all.front().side;
    start = all.front().from;
    launch.push = static_cast<double>(all.front().to - start);
    launch.gain = static_cast<double>((amplitude - level) * (all.front().to - start));
  }
  launch.left = static_cast<double>(piece.to - start);
  launch.theta = static_cast<double>(launch.side * asked.initial.angle * alpha);
  launch.thetadot = static_cast<double>(launch.side * asked.initial.velocity * alpha);
  const auto mirrored = [&](Real over_g) { return static_cast<double>(launch.side * alpha * over_g); };
  launch.ground = mirrored(emitted::ground_of_sine_pulse<Real>(amplitude, 1, piece.phase, start));
  launch.quadrature = mirrored(emitted::quadrature_of_sine_pulse<Real>(amplitude, 1, piece.phase, start));
  return launch;
}

/// Velocities over alpha p below this are those of a block that is about to rest.
constexpr double slow = 1e-3;

/// (22), (34): the code of a motion that the pulse leaves on the side theta > 0 of its last impact.
int code_of(const Block& block, const BatchEnd& end, int first_side) {
  const int side = end.impacts % 2 == 0 ? first_side : -first_side;
  if (end.how == BatchEnd::How::lies) return side * (end.impacts + 1);
  const double alpha = block.alpha, angle = end.theta / alpha, velocity = end.thetadot / alpha;
  if (velocity > emitted::critical_velocity_positive(alpha, angle)) return side * (end.impacts + 1);
  const double impact = emitted::impact_velocity_squared_positive(alpha, angle, velocity),
               launch = emitted::critical_velocity_positive(alpha, 0.0);
  const bool returns = block.restitution * std::sqrt(std::max(0.0, impact)) > launch;
  return returns ? -side * (end.impacts + 2) : 0;
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
  PulseCase asked = asked_;
  asked.omega_ratio = omega_ratio;
  std::vector<int> codes(amplitudes_.size(), 0);
  std::vector<BatchStart> starts;
  std::vector<std::size_t> moving;
  for (std::size_t i = 0; i < launches_.size(); ++i) {
    const Launch& from = launches_[i];
    if (from.side == 0) continue;
    moving.push_back(i);
    starts.push_back({omega_ratio, from.theta, from.thetadot, from.ground, from.quadrature,
                      from.push / omega_ratio, from.left / omega_ratio});
  }
  std::vector<BatchEnd> ends(starts.size());
  const double alpha = asked.block.alpha;
  kernel_.run({alpha, asked.block.restitution, alpha * asked.tolerance, alpha * slow}, starts.data(),
              ends.data(), static_cast<int>(starts.size()));
  for (std::size_t k = 0; k < moving.size(); ++k) {
    const Launch& from = launches_[moving[k]];
    const bool weak = from.push > 0 && from.gain < slow * omega_ratio;
    codes[moving[k]] = weak || ends[k].how == BatchEnd::How::unresolved
                           ? outcome_at(asked, amplitudes_[moving[k]]).code
                           : code_of(asked.block, ends[k], from.side);
  }
  return codes;
}

}  // namespace numeric
}  // namespace rederive
