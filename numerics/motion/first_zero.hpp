// Events in the lanes of a vector V: the first zero of a polynomial, by bounds of its second derivative and
// Newton's iteration. As in kernel.hpp, everything depends on the type V.
#pragma once

#include <cstddef>
#include <experimental/simd>

namespace rederive::numerics {

/// A polynomial y of the time and its rate v, as emitted::value_at has the value.
template <class V, std::size_t size>
void sample(const V (&series)[size], V time, V& y, V& v) {
  constexpr std::size_t last = size - 1, last_even = last - last % 2, last_odd = last - (last + 1) % 2;
  const V square = time * time;
  V even = series[last_even], odd = series[last_odd], even_rate = V(0), odd_rate = V(0);
#pragma GCC unroll 32
  for (std::size_t k = last_even; k > 0; k -= 2)
    even_rate = even_rate * square + even, even = even * square + series[k - 2];
#pragma GCC unroll 32
  for (std::size_t k = last_odd; k > 1; k -= 2)
    odd_rate = odd_rate * square + odd, odd = odd * square + series[k - 2];
  y = even + time * odd, v = odd + V(2) * time * (even_rate + time * odd_rate);
}

/// The zero of y in each of the lanes `open`, between `low` and `high`, where y falls all along: Newton's
/// iteration in a bracket, from the zero of the parabola with the rates v_low and v_high.
template <class V, std::size_t size>
V falling_zero(const V (&series)[size], V low, V y_low, V v_low, V high, V v_high,
               typename V::mask_type open) {
  const V bend = (v_low - v_high) / (high - low);
  V time = high, y = y_low, v = v_high;
  V next = low + V(2) * y_low / (sqrt(max(V(0), v_low * v_low + V(2) * bend * y_low)) - v_low);
  for (int i = 0; i < 100 && any_of(open); ++i) {
    where(!(next > low && next < high), next) = low + (high - low) / 2;
    V y_next, v_next;
    sample(series, next, y_next, v_next);
    const V moved = fabs(next - time);
    where(open, time) = next;
    where(open, y) = y_next;
    where(open, v) = v_next;
    where(open && y > 0, low) = time;
    where(open && y <= 0, high) = time;
    open = open && moved > 1e-5 * time;  // the error goes with the square, and once more below
    next = time - y / v;
  }
  return time - y / v;
}

/// In each lane: the time of the first zero; or, not found, one until which there is none.
template <class V>
struct FirstZero {
  V time;
  typename V::mask_type found, unclear;
};

/// The first zero after 0, at most at `until`, of a polynomial y with y >= 0 at 0 and -below <= y'' <= above.
/// There is none before y + v t - below t^2/2 has come to 0: so far one may go, a few times, until the rate
/// keeps all along the sign that it has at one end, or y is above its chord less above (t - low)(high - t)/2.
template <class V, std::size_t size>
FirstZero<V> first_zero(const V (&series)[size], V until, V above, V below, typename V::mask_type open) {
  using Mask = typename V::mask_type;
  FirstZero<V> zero{until, Mask(false), Mask(false)};
  V low = V(0), y = series[0], v = series[1], y_end, v_end;
  sample(series, until, y_end, v_end);
  const Mask crosses = y_end <= 0;
  const V dip = sqrt(V(0.5) * above), at_end = sqrt(max(V(0), y_end));
  Mask falls = Mask(false);
  for (int i = 0;; ++i) {
    const V length = until - low;
    const Mask falling = v + above * length < 0 || v_end + below * length < 0;
    falls = falls || (open && crosses && falling);
    open = open && !falling && (crosses || !(v >= below * length || sqrt(y) + at_end >= length * dip));
    if (i == 3 || none_of(open)) break;
    const V next = low + (v + sqrt(v * v + V(2) * below * y)) / below, there = min(next, until);
    V y_there, v_there;
    sample(series, there, y_there, v_there);
    where(open, low) = there;
    where(open, y) = y_there;
    where(open, v) = v_there;
    const Mask touches = open && y <= 0;  // by rounding, or at the end
    where(touches, zero.time) = there;
    zero.found = zero.found || (touches && v < 0);
    zero.unclear = zero.unclear || (touches && v >= 0);
    open = open && !touches && next < until;
  }
  if (any_of(open)) {  // no farther than here, or, where y falls, than it is sure to
    where(open, until) = low - V(0.5) * min(V(0), v) / above;
    sample(series, until, y_end, v_end);
    where(open, zero.time) = until;
    falls = falls || (open && y_end <= 0);
  }
  if (any_of(falls)) {
    where(falls, zero.time) = falling_zero(series, low, y, v, until, v_end, falls);
    zero.found = zero.found || falls;
  }
  return zero;
}

}  // namespace rederive::numerics
