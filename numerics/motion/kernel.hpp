// The kernel of the motion: Taylor steps, events, impacts, and the outcome as soon as it is certain.
//
// It follows one motion in each lane of a vector V = std::experimental::simd<T>: many motions of a map in
// lanes of double, one motion in a single lane of long double. The steps are those of A. Jorba and M. Zou, A
// software package for the numerical integration of ODEs by means of high-order Taylor methods, Experimental
// Mathematics 14 (2005) 99-117. This header is compiled once for each instruction set: it may define only
// what depends on V, so that the linker cannot take code of one set for another's.
#pragma once

#include <cmath>
#include <cstdint>
#include <emitted/rocking_block.hpp>
#include <experimental/simd>
#include <numbers>
#include <numerics/motion/first_zero.hpp>
#include <numerics/motion/kernel_case.hpp>
#include <type_traits>

namespace rederive::numerics {

/// Returns x^(1/n) or up to 7 percent more, by a logarithm that is linear between powers of two. The result
/// is the same on any machine.
template <class V>
V rough_root(V x, int n) {
  using Bits = std::experimental::rebind_simd_t<std::uint64_t, V>;
  constexpr double counting = 0x1p52;  // whose last bits count in ones
  constexpr double one = __builtin_bit_cast(std::uint64_t, 1.0) >> 20;
  const Bits power = (__builtin_bit_cast(Bits, x) >> 20) | Bits(__builtin_bit_cast(std::uint64_t, counting));
  const V of_root = (__builtin_bit_cast(V, power) - V(counting + one)) * V(1.0 / n) + V(counting + one);
  return __builtin_bit_cast(V, __builtin_bit_cast(Bits, of_root) << 20);
}

/// The motions that wait for a lane, and how many are in lanes.
template <class T>
struct KernelQueue {
  const KernelStart<T>* starts;
  KernelEnd<T>* ends;
  int count, next, running;
};

/// The motions in the lanes of V, each on the side theta > 0: at an impact the ground is mirrored instead.
/// Motion is an emitted stepper of (21b) or (56b), under a pulse or under a straight line.
template <class V, class Motion>
class LanePack {
  using T = typename V::value_type;
  using Mask = typename V::mask_type;
  using Start = KernelStart<T>;
  using End = KernelEnd<T>;

 public:
  LanePack(const KernelBlock<T>& block, KernelQueue<T>& queue)
      : block_(block),
        queue_(queue),
        sin_(is_nonlinear ? std::sin(block.alpha) : T(0)),
        cos_(is_nonlinear ? std::cos(block.alpha) : T(1)),
        weight_(is_nonlinear ? sin_ : block.alpha),
        barrier_(2 * (is_nonlinear ? std::sin(block.alpha / 2) : block.alpha / 2)) {
    motion_.alpha = block.alpha, motion_.p = 1;
    for (int lane = 0; lane < lanes; ++lane) fill(lane);
  }

  // The parts of a step. Rare work is in separate functions that take no vectors as arguments: those would
  // leave the upper halves of registers in use and slow down all scalar code.

  [[gnu::flatten]] void expand() { motion_.expand(); }

  /// Chooses the step of each lane by the last terms of its series. It is no longer than the ground motion,
  /// from rest no longer than the first push, and after an impact little longer than the expected hop.
  [[gnu::flatten]] void choose_step() {
    const V velocity = motion_.thetadot[0], bend = motion_.theta[2];
    const Mask upright = motion_.theta[0] == 0;
    launched_ = upright && velocity == 0;
    const V size = is_nonlinear ? V(1) : max(V(1), motion_.theta[0]);  // linear motion grows without end
    h_ = min(motion_.step_size(V(block_.tolerance) * size), left_);
    if (none_of(upright)) return;
    where(launched_, h_) = min(h_, push_);
    where(upright && velocity > 0 && bend < 0, h_) = min(h_, V(-1.25) * velocity / bend);
  }

  /// Finds what happens on the step. Most lanes certainly neither come to upright nor lie, and some certainly
  /// lie. An event, and a doubt that cannot be settled at once, makes the step shorter.
  [[gnu::flatten]] void look_ahead() {
    const V after = emitted::value_at(motion_.theta, h_);
    stands_ = launched_ || stays_above(after);
    lies_ = stands_ && after >= lying;
    leans_ = !lies_ && !stays_low(after);
    hits_ = unclear_ = slow_hit_ = Mask(false);
    if (!all_of(stands_) || any_of(leans_)) find_events();
  }

  /// Moves to the end of the step, and in a lane whose motion is over to the next motion.
  [[gnu::flatten]] void advance() {
    move();
    if constexpr (is_pulse)
      if (block_.codes_only) foresee();
    over_ = left_ <= 0 || lies_ || overturns_ || returns_ || safe_ || slow_hit_ || unclear_ ||
            steps_ > T(block_.most_steps);
    if (any_of(over_)) retire();
  }

  /// The series of theta on the step of a lane, and its length, as look_ahead leaves them.
  using Series = std::remove_reference_t<decltype(std::declval<Motion&>().theta)>;
  const Series& series() const { return motion_.theta; }
  V length() const { return h_; }

 private:
  static constexpr int lanes = static_cast<int>(V::size());
  static constexpr int order = static_cast<int>(std::extent_v<decltype(Motion::theta)>) - 1;
  static constexpr bool is_nonlinear = requires(Motion motion) { motion.sin_1; };
  static constexpr bool is_pulse = requires(Motion motion) { motion.quadrature; };
  static constexpr T lying = is_nonlinear ? std::numbers::pi_v<T> / 2 : T(1e300);

  [[gnu::noinline]] void find_events() {
    V change = V(0), power = V(1);  // of theta'' on the step, by its series
    for (int k = 3; k <= order; ++k) power *= h_, change += T(k * (k - 1)) * fabs(motion_.theta[k]) * power;
    const V bend = T(2) * motion_.theta[2], tiny = V(1e-30), most = amplitude_ + V(is_nonlinear ? 1 : 1e300),
            above = min(most, max(change + bend, tiny)),
            below = min(amplitude_ + weight_, max(change - bend, tiny));
    const FirstZero<V> impact = first_zero(motion_.theta, h_, above, below, !stands_);
    hits_ = impact.found, unclear_ = impact.unclear;
    h_ = impact.time;
    if (none_of(leans_)) return;
    V room[order + 1];  // to where it lies
    for (int k = 0; k <= order; ++k) room[k] = -motion_.theta[k];
    room[0] += lying;
    const FirstZero<V> fall = first_zero(room, h_, below, above, leans_);
    hits_ = hits_ && fall.time >= h_;
    lies_ = lies_ || fall.found, unclear_ = unclear_ || fall.unclear;
    h_ = fall.time;
  }

  /// Moves to the end of the step; an impact (34) is seen from the other side.
  void move() {
    motion_.advance(h_);
    left_ -= h_;
    steps_ += 1;
    if (none_of(hits_)) return;
    const V rebound = -block_.restitution * motion_.thetadot[0];
    where(hits_, motion_.theta[0]) = 0;
    where(hits_, motion_.thetadot[0]) = rebound;
    where(hits_, motion_.ground[0]) = -motion_.ground[0];
    if constexpr (is_pulse)
      where(hits_, motion_.quadrature[0]) = -motion_.quadrature[0];
    else
      where(hits_, motion_.slope) = -motion_.slope;
    if constexpr (is_nonlinear) {
      where(hits_, motion_.sin_1[0]) = sin_;
      where(hits_, motion_.cos_1[0]) = cos_;
    }
    where(hits_, impacts_) += 1;
    where(hits_, launched_left_) = left_;
    slow_hit_ = hits_ && !(rebound > slow_);
  }

  /// What is certain of the code before the pulse is over, by energy (22); psi = alpha - theta. Let G be the
  /// most that the ground may still push inwards, and J the integral of its size.
  ///
  /// Overturns: while theta' > 0, theta'^2/2 + cos(psi) - G sin(psi) does not fall, and at rest it is
  /// (1 + G^2)^(1/2) at most; nor is there a way back from where the weight outdoes G. Linear: the rate of
  /// theta' + theta - alpha is itself less the ground, so from above G it does not fall. When the pulse is
  /// over, too, beyond alpha with less energy than there.
  ///
  /// Safe: the velocity u at upright, u^2 = theta'^2 + 2 cos(psi) - 2 cos(alpha), changes no faster than by
  /// the size of the ground while 0 < theta < alpha, and falls at impacts: from below the barrier less J it
  /// never passes the barrier.
  ///
  /// Returns: a block that moves inwards gains energy from ground that only pushes inwards, and after the
  /// impact outwards, so it overturns to the other side if e u passes the barrier.
  void foresee() {
    constexpr double rounding = 1e-13;
    const V velocity = motion_.thetadot[0], lean = motion_.theta[0] - block_.alpha,
            ground = motion_.ground[0], quadrature = motion_.quadrature[0];
    const Mask over = left_ <= 0, fades = left_ <= fading_, inwards = ground >= -1e-6 * amplitude_;
    V most = amplitude_, integral = amplitude_ * left_;
    where(fades && !(inwards && quadrature >= 0), most) = max(V(0), ground);
    where(fades, integral) = (amplitude_ - quadrature) / motion_.omega_p;
    where(fades && inwards, integral) = (amplitude_ + quadrature) / motion_.omega_p;
    V upright;
    Mask beyond;  // alpha, from where free motion does not come back
    const V square = velocity * velocity;
    if constexpr (is_nonlinear) {
      const V sine = motion_.sin_1[0], cosine = motion_.cos_1[0], energy = V(0.5) * square + cosine,
              height = energy - most * sine;
      overturns_ = velocity > 0 &&
                   (sine + most * cosine < 0 || (height > 0 && height * height > 1 + rounding + most * most));
      beyond = lean > 0 && energy < 1 - rounding;
      upright = square + 2 * (cosine - cos_);
    } else {
      overturns_ = velocity + lean > most;
      beyond = lean > 0 && square < lean * lean;
      upright = square + (block_.alpha * block_.alpha - lean * lean);
    }
    overturns_ = overturns_ || (over && beyond);
    const V room = barrier_ - integral;
    safe_ = lean < 0 && room > 0 && upright + rounding < room * room;
    returns_ = velocity < 0 && (over || (fades && inwards && lean < 0)) &&
               block_.restitution * block_.restitution * upright > barrier_ * barrier_ + rounding;
  }

  /// Hands back the motions that are over.
  [[gnu::noinline]] void retire() {
    for (int lane = 0; lane < lanes; ++lane)
      if (over_[at(lane)])
        finish(lane, lies_[at(lane)]        ? End::How::lies
                     : overturns_[at(lane)] ? End::How::overturns
                     : returns_[at(lane)]   ? End::How::returns
                     : safe_[at(lane)]      ? End::How::safe
                     : slow_hit_[at(lane)]  ? End::How::slow
                     : left_[at(lane)] <= 0 ? End::How::pulse_over
                                            : End::How::unclear);
  }

  /// Returns a bound of the acceleration outwards, as far as theta.
  V outward(V theta) const { return amplitude_ + max(V(0), theta - block_.alpha); }

  /// Whether y with y'' <= 2 fall over a time of 1 certainly stays above 0 between these values: if not,
  /// y1^(1/2) + y2^(1/2) < fall^(1/2).
  static Mask stays_positive(V y1, V y2, V fall) {
    const V least = min(y1, y2);
    return y1 + y2 + 2 * least >= fall && least >= 0;
  }

  /// Returns whether the block certainly does not come to upright; see first_zero, on either half of the
  /// step.
  Mask stays_above(V after) const {
    const V before = motion_.theta[0], middle = emitted::value_at(motion_.theta, V(0.5) * h_);
    const V fall = V(0.125) * h_ * h_ * outward(max(before, after));
    return stays_positive(before, middle, fall) && stays_positive(middle, after, fall);
  }

  /// Returns whether the block certainly does not come to lie: no acceleration inwards exceeds the one that
  /// the ground and the weight cause.
  Mask stays_low(V after) const {
    if (!is_nonlinear) return Mask(true);
    const V fall = V(0.5) * h_ * h_ * (amplitude_ + weight_);
    return stays_positive(lying - motion_.theta[0], lying - after, fall);
  }

  /// Puts the next motion into a lane or, if none waits, a block at rest on its corner.
  void fill(int lane) {
    const bool waits = queue_.next < queue_.count;
    const Start start =
        waits ? queue_.starts[queue_.next] : Start{.rate = 1, .theta = block_.alpha, .left = 1};
    index_[lane] = waits ? queue_.next++ : -1;
    queue_.running += waits ? 1 : 0;
    const auto set = [&](V& of, T value) { of[at(lane)] = value; };
    set(motion_.theta[0], start.theta), set(motion_.thetadot[0], start.thetadot);
    set(motion_.ground[0], start.ground);
    if constexpr (is_pulse) {
      set(motion_.omega_p, start.rate), set(motion_.quadrature[0], start.quadrature);
      set(amplitude_, std::sqrt(start.ground * start.ground + start.quadrature * start.quadrature));
    } else {
      set(motion_.slope, start.rate);
      const T end = start.ground + start.rate * start.left;
      set(amplitude_, std::fabs(start.ground) > std::fabs(end) ? std::fabs(start.ground) : std::fabs(end));
    }
    if constexpr (is_nonlinear) {
      set(motion_.sin_1[0], start.theta == 0 ? sin_ : std::sin(block_.alpha - start.theta));
      set(motion_.cos_1[0], start.theta == 0 ? cos_ : std::cos(block_.alpha - start.theta));
    }
    set(left_, start.left), set(launched_left_, start.left), set(push_, start.push), set(steps_, 0);
    set(impacts_, start.impacts), set(fading_, start.fading), set(slow_, start.slow);
  }

  void finish(int lane, typename End::How how) {
    if (index_[lane] < 0) return;
    queue_.ends[index_[lane]] = {how,
                                 motion_.theta[0][at(lane)],
                                 motion_.thetadot[0][at(lane)],
                                 left_[at(lane)],
                                 launched_left_[at(lane)],
                                 static_cast<int>(impacts_[at(lane)])};
    --queue_.running;
    fill(lane);
  }

  static std::size_t at(int lane) { return static_cast<std::size_t>(lane); }

  KernelBlock<T> block_;
  KernelQueue<T>& queue_;
  T sin_, cos_, weight_, barrier_;
  Motion motion_;
  V left_, fading_, launched_left_, push_, amplitude_, steps_, impacts_, slow_, h_;
  Mask launched_, stands_, leans_, hits_, lies_, unclear_, slow_hit_, over_, overturns_{false},
      returns_{false}, safe_{false};
  int index_[lanes];
};

/// Follows motions in three packs of lanes, each a part of a step after the other: while one waits for its
/// last operation, the others go on.
template <class V, class Motion>
void run_packs(const KernelBlock<double>& block, const KernelStart<double>* starts, KernelEnd<double>* ends,
               int count) {
  using Pack = LanePack<V, Motion>;
  KernelQueue<double> queue{starts, ends, count, 0, 0};
  Pack packs[] = {{block, queue}, {block, queue}, {block, queue}};
  while (queue.running > 0)
    for (const auto part : {&Pack::expand, &Pack::choose_step, &Pack::look_ahead, &Pack::advance})
      for (Pack& pack : packs) (pack.*part)();
}

/// Follows one motion in the one lane of V, and calls `step(series of theta, length)` for each step.
template <class V, class Motion, class Step>
KernelEnd<typename V::value_type> run_one(const KernelBlock<typename V::value_type>& block,
                                          const KernelStart<typename V::value_type>& start,
                                          const Step& step) {
  using T = typename V::value_type;
  KernelEnd<T> end{};
  KernelQueue<T> queue{&start, &end, 1, 0, 0};
  LanePack<V, Motion> pack(block, queue);
  while (queue.running > 0) {
    pack.expand();
    pack.choose_step();
    pack.look_ahead();
    step(pack.series(), static_cast<T>(pack.length()[0]));
    pack.advance();
  }
  return end;
}

}  // namespace rederive::numerics
