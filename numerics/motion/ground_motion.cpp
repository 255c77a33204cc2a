#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <emitted/rocking_block.hpp>
#include <numbers>
#include <numerics/motion/ground_motion.hpp>
#include <stdexcept>

namespace rederive::numerics {
namespace {

constexpr Real pi = std::numbers::pi_v<Real>;

/// Returns whether low <= centre + 2 pi k <= high for some whole k.
bool holds_phase(Real low, Real high, Real centre) {
  return std::ceil((low - centre) / (2 * pi)) <= std::floor((high - centre) / (2 * pi));
}

Real time_of_phase(const Piece& piece, Real phase) {
  return piece.from + (phase - piece.phase) / piece.omega;
}

std::vector<Push> pushes_of_sine(const Piece& piece, Real level) {
  std::vector<Push> all;
  if (!(piece.amplitude > level)) return all;
  const Real psi = emitted::phase_of_sine_pulse(level / piece.amplitude);
  const Real last = piece.phase + piece.omega * (piece.to - piece.from);
  for (int lobe = 0; lobe * pi < last; ++lobe) {
    const Real begin = lobe * pi + psi, end = (lobe + 1) * pi - psi;
    if (end <= piece.phase || begin >= last) continue;
    all.push_back({std::max(piece.from, time_of_phase(piece, begin)),
                   std::min(piece.to, time_of_phase(piece, end)), lobe % 2 == 0 ? -1 : 1});
  }
  return all;
}

std::vector<Push> pushes_of_line(const Piece& piece, Real level) {
  std::vector<Push> all;
  for (int sign : {1, -1}) {  // sign * ground > level drives to the side -sign
    const Real first = sign * piece.value - level;
    const Real last = first + sign * piece.slope * (piece.to - piece.from);
    if (first <= 0 && last <= 0) continue;
    const Real crossing = first == last ? piece.from : piece.from - sign * first / piece.slope;
    all.push_back({first >= 0 ? piece.from : crossing, last >= 0 ? piece.to : crossing, -sign});
  }
  std::sort(all.begin(), all.end(), [](const Push& a, const Push& b) { return a.from < b.from; });
  return all;
}

}  // namespace

Real pulse_phase(Pulse pulse, Real amplitude, Real level) {
  return pulse == Pulse::sine ? emitted::phase_of_sine_pulse(level / amplitude)
                              : emitted::phase_of_cosine_pulse(level / amplitude);
}

Real pulse_end(Pulse pulse, Real omega_ratio, Real psi) {
  return pulse == Pulse::sine ? emitted::end_of_sine_pulse(omega_ratio, psi)
                              : emitted::end_of_cosine_pulse(omega_ratio, psi);
}

GroundMotion pulse_motion(Pulse pulse, Real omega_ratio, Real amplitude, Real level) {
  if (!(omega_ratio > 0 && std::isfinite(omega_ratio)))
    throw std::invalid_argument(
        fmt::format("omega_p/p = {} must be positive", static_cast<double>(omega_ratio)));
  if (!(std::isfinite(amplitude) && amplitude >= level))
    throw std::invalid_argument(fmt::format("amplitude = {}: no instant at which rocking can start, below {}",
                                            static_cast<double>(amplitude), static_cast<double>(level)));
  Piece piece;
  piece.amplitude = amplitude;
  piece.omega = omega_ratio;
  const Real psi = pulse_phase(pulse, amplitude, level);
  // a cos(x + psi) = a sin(x + psi + pi/2), and psi + pi/2 to the last digit as pushes has it.
  piece.phase = pulse == Pulse::sine ? psi : pi - pulse_phase(Pulse::sine, amplitude, level);
  piece.to = pulse_end(pulse, omega_ratio, psi);
  return {piece};
}

Real ground_at(const Piece& piece, Real time) {
  const Real since = time - piece.from;
  Real value = piece.value + piece.slope * since;
  if (piece.amplitude != 0)
    value += emitted::ground_of_sine_pulse(piece.amplitude, piece.omega, piece.phase, since);
  return value;
}

Range ground_range(const Piece& piece, Real from, Real to) {
  const Real a = ground_at(piece, from), b = ground_at(piece, to);
  Range range{std::min(a, b), std::max(a, b)};
  if (piece.amplitude == 0) return range;
  const Real low = piece.omega * (from - piece.from) + piece.phase;
  const Real high = piece.omega * (to - piece.from) + piece.phase;
  if (holds_phase(low, high, pi / 2)) range.high = piece.amplitude;
  if (holds_phase(low, high, -pi / 2)) range.low = -piece.amplitude;
  return range;
}

double most_ground(const Piece& piece, Real from, Real to) {
  const auto since = static_cast<double>(from - piece.from), until = static_cast<double>(to - piece.from);
  const auto slope = static_cast<double>(piece.slope), value = static_cast<double>(piece.value);
  if (piece.amplitude == 0) return std::max(std::abs(value + slope * since), std::abs(value + slope * until));
  const auto amplitude = std::abs(static_cast<double>(piece.amplitude)),
             omega = static_cast<double>(piece.omega), phase = static_cast<double>(piece.phase);
  const double low = omega * since + phase, high = omega * until + phase;
  if (std::floor(low / std::numbers::pi - 0.5) != std::floor(high / std::numbers::pi - 0.5)) return amplitude;
  return amplitude * std::max(std::abs(std::sin(low)), std::abs(std::sin(high)));
}

std::vector<Push> pushes(const Piece& piece, Real level) {
  return piece.amplitude != 0 ? pushes_of_sine(piece, level) : pushes_of_line(piece, level);
}

}  // namespace rederive::numerics
