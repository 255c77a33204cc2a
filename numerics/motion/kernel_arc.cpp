#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numerics/motion/kernel.hpp>
#include <numerics/motion/kernel_arc.hpp>
#include <numerics/motion/reference.hpp>
#include <optional>
#include <utility>

namespace {

using LongLane = std::experimental::simd<long double, std::experimental::simd_abi::scalar>;
using DoubleLane = std::experimental::fixed_size_simd<double, 1>;

}  // namespace

/// A step size needs few digits.
template <>
inline LongLane rederive::emitted::root(LongLane x, int n) {
  return std::pow(static_cast<double>(static_cast<long double>(x[0])), 1.0 / n);
}

template <>
inline DoubleLane rederive::emitted::root(DoubleLane x, int n) {
  return std::pow(static_cast<double>(x[0]), 1.0 / n);
}

namespace rederive::numerics {
namespace {

/// A step of an arc: theta on the side theta > 0, as a series from the time `from`.
template <std::size_t size>
struct Step {
  Real from;
  Real theta[size];
};

/// The state on an arc, from its steps.
template <std::size_t size>
Point state_at(const std::vector<Step<size>>& steps, Real scale, Real time) {
  const auto later = std::ranges::upper_bound(steps, time, {}, &Step<size>::from);
  const Step<size>& step = later == steps.begin() ? *later : *std::prev(later);
  Real theta = 0, thetadot = 0;
  sample(step.theta, time - step.from, theta, thetadot);
  return {time, theta == 0 ? 0 : theta / scale, thetadot == 0 ? 0 : thetadot / scale};  // not -0
}

/// Returns the time at which the block lies, on a step that ends after `length` beyond theta = pi/2.
template <std::size_t size>
Real time_of_lying(const Step<size>& step, Real length) {
  LongLane room[size], y, v;
  for (std::size_t k = 0; k < size; ++k) room[k] = -step.theta[k];
  room[0] += std::numbers::pi_v<Real> / 2;
  sample(room, LongLane(length), y, v);
  const LongLane after =
      falling_zero(room, LongLane(0), room[0], room[1], LongLane(length), v, LongLane::mask_type(true));
  return step.from + static_cast<Real>(after[0]);
}

/// The arc from a start; nothing if it is unclear. `scale` has the sign of the side.
template <class Lane, class Motion, class T>
std::optional<Arc> arc_from(const KernelBlock<T>& block, const KernelStart<T>& start, Arc arc, Real scale,
                            bool keeps_history) {
  constexpr std::size_t size = std::extent_v<decltype(Motion::theta)>;
  std::vector<Step<size>> steps;
  Real time = arc.start.time;
  const KernelEnd<T> end = run_one<Lane, Motion>(block, start, [&](const auto& series, T length) {
    if (!keeps_history) return;
    Step<size>& step = steps.emplace_back();
    step.from = time;
    for (std::size_t k = 0; k < size; ++k) step.theta[k] = static_cast<T>(series[k][0]);
    time += length;
  });
  using How = typename KernelEnd<T>::How;
  if (end.how == How::unclear) return std::nullopt;
  arc.end = {arc.piece.to - end.left, end.theta / scale, end.thetadot / scale};
  if (end.how == How::slow) {  // every impact ends an arc
    arc.kind = ArcEnd::impact;
    arc.end.angle = 0;  // not -0
    arc.rebound = -end.thetadot / scale;
    arc.end.velocity = arc.rebound / block.restitution;
  } else if (end.how == How::lies) {
    arc.kind = ArcEnd::lies;
    if (keeps_history)  // the kernel ends the motion behind theta = pi/2
      arc.end = state_at(steps, scale, time_of_lying(steps.back(), time - steps.back().from));
  }
  if (keeps_history)
    arc.at = [steps = std::move(steps), scale](Real at) { return state_at(steps, scale, at); };
  return arc;
}

/// Returns how long the ground continues to push a block that starts from rest.
Real length_of_push(const std::vector<Push>& all, int side, Real time) {
  for (const Push& push : all)
    if (push.side == side && push.from <= time && time < push.to) return push.to - time;
  return 0;
}

template <class Lane>
class KernelMover {
  using T = typename Lane::value_type;

 public:
  KernelMover(const Block& block, Model model, const ResponseOptions& options)
      : model_(model),
        scale_(kernel_scale(block, model)),
        level_(start_level(block, model)),
        keeps_history_(options.history),
        reference_(reference_follower(block, model, options)) {
    block_ = {.is_linear = model == Model::linear,
              .alpha = static_cast<T>(scale_),
              .restitution = static_cast<T>(block.restitution),
              .tolerance = static_cast<T>(scale_) * std::numeric_limits<T>::epsilon()};
  }

  Arc operator()(const Piece& piece, int side, const Point& start) const {
    KernelStart<T> from = kernel_start<T>(piece, side, start, scale_);
    from.slow = std::numeric_limits<T>::infinity();
    if (from.theta == 0 && from.thetadot == 0)
      from.push = static_cast<T>(length_of_push(pushes(piece, level_), side, start.time));
    const Arc begun{.piece = piece, .side = side, .start = start, .end = start};
    std::optional<Arc> arc = is_line(piece) ? on_line(from, begun) : in_pulse(from, begun);
    return arc ? std::move(*arc) : reference_(piece, side, start);
  }

 private:
  /// An arc by the stepper of the model, one of two.
  template <class Linear, class Nonlinear>
  std::optional<Arc> arc_by(const KernelStart<T>& from, const Arc& begun) const {
    const Real scale = begun.side * scale_;
    return model_ == Model::linear ? arc_from<Lane, Linear>(block_, from, begun, scale, keeps_history_)
                                   : arc_from<Lane, Nonlinear>(block_, from, begun, scale, keeps_history_);
  }

  std::optional<Arc> in_pulse(const KernelStart<T>& from, const Arc& begun) const {
    constexpr int order = 24;
    return arc_by<emitted::linear_motion_in_pulse_positive<Lane, order>,
                  emitted::motion_in_pulse_positive<Lane, order>>(from, begun);
  }

  std::optional<Arc> on_line(const KernelStart<T>& from, const Arc& begun) const {
    constexpr int order = sizeof(T) > 8 ? 10 : 8;  // samples of a record are close together
    return arc_by<emitted::linear_motion_on_line_positive<Lane, order>,
                  emitted::motion_on_line_positive<Lane, order>>(from, begun);
  }

  KernelBlock<T> block_;
  Model model_;
  double scale_;
  Real level_;
  bool keeps_history_;
  Follow reference_;
};

}  // namespace

Follow kernel_follower(const Block& block, Model model, const ResponseOptions& options) {
  if (options.in_double) return KernelMover<DoubleLane>(block, model, options);
  return KernelMover<LongLane>(block, model, options);
}

}  // namespace rederive::numerics
