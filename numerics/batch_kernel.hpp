// The kernel: step, event, lane. Compiled once for each instruction set; only what depends on the type of the
// vector V, or is static, may be defined here, so that no code of one set is taken for another's.
#pragma once

#include <cmath>
#include <cstdint>
#include <emitted/rocking_block.hpp>
#include <experimental/simd>
#include <numbers>
#include <numerics/batch.hpp>

namespace rederive {

constexpr int batch_order = 18;

/// x^(1/n) to half a percent, by a logarithm that is linear between powers of two: the same on any machine.
template <class V>
V rough_root(V x, int n) {
  namespace simd = std::experimental;
  alignas(simd::memory_alignment_v<V>) double lanes[V::size()];
  x.copy_to(lanes, simd::vector_aligned);
  constexpr auto one = __builtin_bit_cast(std::int64_t, 1.0);
  for (double& lane : lanes) {
    const auto power = static_cast<double>(__builtin_bit_cast(std::int64_t, lane) - one) / n;
    lane = __builtin_bit_cast(double, static_cast<std::int64_t>(power) + one);
  }
  return V(lanes, simd::vector_aligned);
}

/// A polynomial y of the time, with -below <= y'' <= above.
struct Crossing {
  double y[batch_order + 1];
  double above, below;
};
struct CrossingSample {
  double time, y, v;
};

static CrossingSample sample_at(const Crossing& of, double time) {
  double y = of.y[batch_order], v = 0;
  for (int k = batch_order - 1; k >= 0; --k) v = v * time + y, y = y * time + of.y[k];
  return {time, y, v};
}

/// Whether y > 0 between two times where y > 0, or y >= 0 at the first: it is below its chord by no more than
/// above (t - low) (high - t)/2; or its rate keeps the sign that it has at one of them.
static bool is_positive(const Crossing& of, const CrossingSample& low, const CrossingSample& high) {
  const double length = high.time - low.time;
  return std::sqrt(low.y) + std::sqrt(high.y) >= length * std::sqrt(of.above / 2) ||
         low.v >= of.below * length || low.v + of.above * length < 0 || high.v + of.below * length < 0;
}

/// The zero of y between two times where y falls all along: Newton's iteration in a bracket.
static double falling_zero(const Crossing& of, CrossingSample low, CrossingSample high) {
  CrossingSample at = high;
  for (int i = 0; i < 100; ++i) {
    double next = at.time - at.y / at.v;
    if (!(next > low.time && next < high.time)) next = low.time + (high.time - low.time) / 2;
    const double moved = std::fabs(next - at.time);
    at = sample_at(of, next);
    (at.y > 0 ? low : high) = at;
    if (moved <= 1e-8 * next) break;  // the error goes with the square
  }
  return at.time - at.y / at.v;
}

enum class Zero { none, found, unclear };

/// The first zero of y after `low`, at most at `high`. With y'' >= -below there is none before y + v t -
/// below t^2/2 has come to 0; from there on the time is halved until one of the two above tells.
static Zero first_zero(const Crossing& of, CrossingSample low, const CrossingSample& high, int depth,
                       double& time) {
  if (high.y > 0 && is_positive(of, low, high)) return Zero::none;
  const double next = low.time + (low.v + std::sqrt(low.v * low.v + 2 * of.below * low.y)) / of.below;
  if (next >= high.time && high.y > 0) return Zero::none;
  low = next < high.time ? sample_at(of, next) : high;
  if (low.y <= 0) {  // by rounding
    time = low.time;
    return low.v < 0 ? Zero::found : Zero::unclear;
  }
  const double length = high.time - low.time;
  if (high.y <= 0 && (low.v + of.above * length < 0 || high.v + of.below * length < 0)) {
    time = falling_zero(of, low, high);
    return Zero::found;
  }
  if (depth == 40) return Zero::unclear;
  const CrossingSample middle = sample_at(of, low.time + length / 2);
  const Zero before = first_zero(of, low, middle, depth + 1, time);
  return before != Zero::none ? before : first_zero(of, middle, high, depth + 1, time);
}

/// The motions that wait for a lane, and how many are on their way.
struct BatchQueue {
  const BatchStart* starts;
  BatchEnd* ends;
  int count, next, running;
};

/// The motions in the lanes of V, each on the side theta > 0: at an impact the ground is mirrored instead.
template <class V>
class BatchPack {
 public:
  BatchPack(const BatchBlock& block, BatchQueue& queue)
      : block_(block), queue_(queue), sin_(std::sin(block.alpha)), cos_(std::cos(block.alpha)) {
    motion_.alpha = block.alpha, motion_.p = 1;
    for (int lane = 0; lane < lanes; ++lane) fill(lane);
  }

  void expand() { motion_.expand(); }

  /// The step of each lane: by the last terms; no longer than the pulse; from rest, than the first push; and
  /// after an impact, by little, than the hop that is to be expected.
  void choose_step() {
    const V velocity = motion_.thetadot[0], bend = motion_.theta[2];
    const Mask upright = motion_.theta[0] == 0;
    launched_ = upright && velocity == 0;
    h_ = min(motion_.step_size(V(block_.tolerance)), left_);
    where(launched_, h_) = min(h_, push_);
    where(upright && velocity > 0 && bend < 0, h_) = min(h_, -1.25 * velocity / bend);
  }

  /// What happens on it: most lanes certainly neither come to upright nor lie, and some lie.
  void look_ahead() {
    const V after = emitted::value_at(motion_.theta, h_);
    const Mask stands = launched_ || stays_above(after);
    lies_ = stands && after >= lying;
    low_ = stays_low(after);
    unclear_ = !(stands && (lies_ || low_));
    if (any_of(unclear_))
      for (int lane = 0; lane < lanes; ++lane) event_[lane] = unclear_[at(lane)] ? event(lane) : Event::none;
  }

  void advance() {
    motion_.advance(h_);
    left_ -= h_;
    ++steps_;
    if (any_of(unclear_))
      for (int lane = 0; lane < lanes; ++lane) happens(lane, event_[lane]);
    const Mask over = left_ <= 0 || lies_ || steps_ > 10'000;
    if (any_of(over))
      for (int lane = 0; lane < lanes; ++lane)
        if (over[at(lane)])
          finish(lane, lies_[at(lane)]        ? BatchEnd::How::lies
                       : left_[at(lane)] <= 0 ? BatchEnd::How::pulse_over
                                              : BatchEnd::How::unclear);
  }

 private:
  static constexpr int lanes = static_cast<int>(V::size());
  static constexpr double lying = std::numbers::pi / 2;
  using Mask = typename V::mask_type;
  enum class Event { none, impact, lies, unclear };

  /// No acceleration outwards exceeds this, as far as theta.
  V outward(V theta) const { return amplitude_ + max(V(0), theta - block_.alpha); }
  /// Nor one inwards this.
  V inward() const { return amplitude_ + sin_; }

  /// Whether the block certainly does not come to upright: is_positive on either half of the step.
  Mask stays_above(V after) const {
    const V before = motion_.theta[0], middle = emitted::value_at(motion_.theta, V(0.5) * h_);
    const V dip = V(0.5) * h_ * sqrt(V(0.5) * outward(max(before, after)));
    return sqrt(before) + sqrt(middle) >= dip && sqrt(middle) + sqrt(after) >= dip;
  }

  /// Whether it certainly does not come to lie.
  Mask stays_low(V after) const {
    return sqrt(lying - motion_.theta[0]) + sqrt(lying - after) >= h_ * sqrt(V(0.5) * inward());
  }

  /// What ends the step of a lane; an impact makes it shorter.
  Event event(int lane) {
    const double length = h_[at(lane)];
    Crossing theta;
    for (int k = 0; k <= batch_order; ++k) theta.y[k] = motion_.theta[k][at(lane)];
    double change = 0, power = 1;  // of y'' on the step, by its series
    for (int k = 3; k <= batch_order; ++k)
      power *= length, change += k * (k - 1) * std::fabs(theta.y[k]) * power;
    constexpr double tiny = 1e-30;
    theta.above = smaller(amplitude_[at(lane)] + 1, larger(change + 2 * theta.y[2], tiny));
    theta.below = smaller(amplitude_[at(lane)] + sin_, larger(change - 2 * theta.y[2], tiny));
    double impact = length, lies = length;
    const Zero zero = launched_[at(lane)] ? Zero::none : search(theta, length, impact);
    if (zero == Zero::unclear) return Event::unclear;
    if (!low_[at(lane)]) {
      for (double& y : theta.y) y = -y;
      theta.y[0] += lying;
      const double inward = theta.below;
      theta.below = theta.above, theta.above = inward;
      const Zero fall = search(theta, length, lies);
      if (fall == Zero::unclear) return Event::unclear;
      if (fall == Zero::found && !(zero == Zero::found && impact < lies)) return Event::lies;
    }
    if (zero == Zero::none) return Event::none;
    h_[at(lane)] = impact;
    return Event::impact;
  }

  static double smaller(double a, double b) { return a < b ? a : b; }
  static double larger(double a, double b) { return a > b ? a : b; }

  static Zero search(const Crossing& of, double length, double& time) {
    return first_zero(of, {0, of.y[0], of.y[1]}, sample_at(of, length), 0, time);
  }

  /// After a step that ended with an event: at an impact (34), seen from the other side.
  void happens(int lane, Event event) {
    if (event == Event::lies) finish(lane, BatchEnd::How::lies);
    if (event == Event::unclear) finish(lane, BatchEnd::How::unclear);
    if (event != Event::impact) return;
    const double speed = -block_.restitution * motion_.thetadot[0][at(lane)];
    set(lane, 0, speed, -motion_.ground[0][at(lane)], -motion_.quadrature[0][at(lane)]);
    ++impacts_[lane];
    if (!(speed > slow_[lane])) finish(lane, BatchEnd::How::slow);
  }

  void set(int lane, double theta, double thetadot, double ground, double quadrature) {
    const double from_barrier = block_.alpha - theta;
    motion_.theta[0][at(lane)] = theta, motion_.thetadot[0][at(lane)] = thetadot;
    motion_.ground[0][at(lane)] = ground, motion_.quadrature[0][at(lane)] = quadrature;
    motion_.sin_1[0][at(lane)] = theta == 0 ? sin_ : std::sin(from_barrier);
    motion_.cos_1[0][at(lane)] = theta == 0 ? cos_ : std::cos(from_barrier);
  }

  /// The next motion, or, for want of one, a block at rest on its corner.
  void fill(int lane) {
    const bool waits = queue_.next < queue_.count;
    const BatchStart start =
        waits ? queue_.starts[queue_.next] : BatchStart{1, block_.alpha, 0, 0, 0, 1, 1, 0};
    index_[lane] = waits ? queue_.next++ : -1;
    queue_.running += waits ? 1 : 0;
    set(lane, start.theta, start.thetadot, start.ground, start.quadrature);
    motion_.omega_p[at(lane)] = start.omega;
    left_[at(lane)] = start.left, push_[at(lane)] = start.push, steps_[at(lane)] = 0;
    amplitude_[at(lane)] = std::sqrt(start.ground * start.ground + start.quadrature * start.quadrature);
    impacts_[lane] = start.impacts, slow_[lane] = start.slow;
  }

  void finish(int lane, BatchEnd::How how) {
    if (index_[lane] < 0) return;
    queue_.ends[index_[lane]] = {how, motion_.theta[0][at(lane)], motion_.thetadot[0][at(lane)],
                                 left_[at(lane)], impacts_[lane]};
    --queue_.running;
    fill(lane);
  }

  static std::size_t at(int lane) { return static_cast<std::size_t>(lane); }

  BatchBlock block_;
  BatchQueue& queue_;
  double sin_, cos_;
  emitted::motion_in_pulse_positive<V, batch_order> motion_;
  V left_, push_, amplitude_, steps_, h_;
  Mask launched_, lies_, low_, unclear_;
  int index_[lanes], impacts_[lanes];
  double slow_[lanes];
  Event event_[lanes];
};

/// Two packs in flight: while one waits for its last operation, the other goes on.
template <class V>
void run_batch(const BatchBlock& block, const BatchStart* starts, BatchEnd* ends, int count) {
  BatchQueue queue{starts, ends, count, 0, 0};
  BatchPack<V> one(block, queue), other(block, queue);
  while (queue.running > 0) {
    one.expand(), other.expand();
    one.choose_step(), other.choose_step();
    one.look_ahead(), other.look_ahead();
    one.advance(), other.advance();
  }
}

}  // namespace rederive
