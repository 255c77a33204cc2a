// Which reading of a printed number reproduces it? Readings are conventions with a name; nothing is fitted.
#pragma once

#include <lessons/rocking_block/claims_bench.hpp>

namespace rederive::rocking_block {

/// Whether a reading of T_ex takes pi as 3.14, in 2*pi and in psi.
struct ShortPi {
  bool in_turn, in_psi;
  bool operator==(const ShortPi&) const = default;
};
/// Returns "2*pi = 6.28, psi exact" and the like.
std::string words_for(const ShortPi& pi);

/// The unit of an amplitude.
enum class Unit { alpha_g, g_tan_alpha, g };

/// One way to read a number: in words, the value that it gives, and what it assumes.
struct Reading {
  std::string says;
  double value = 0;
  numerics::Model model = numerics::Model::linear;
  bool has_own_restitution = false;  ///< e of (46)
  Unit unit = Unit::alpha_g;
  bool is_reciprocal = false;
  std::optional<ShortPi> pi = {};  ///< of T_ex
};

/// A reading beside a printed number: `off` in units of its last digit.
struct Match {
  Reading reading;
  double off = 0;
  bool rounds = false;  ///< gives the printed digits when rounded
};

/// The readings by distance from the printed number ("0.672"; the digits after its point count), nearest
/// first.
std::vector<Match> compare_with(const std::string& printed, const std::vector<Reading>& readings);
/// Those that lie between two printed numbers, one below and one above a threshold.
std::vector<Reading> between(const std::string& one, const std::string& other,
                             const std::vector<Reading>& readings);

/// "fits: …" for all that round to it, else "none of N readings fits; the nearest …".
std::string summary(const std::vector<Match>& matches);
/// The readings that round to the printed number.
std::vector<Reading> fitting(const std::vector<Match>& matches);

/// A threshold read in every way: linear or nonlinear, alpha = 0.25 or atan(0.25), e of (46), 0.9 or 1, in
/// alpha*g, g*tan(alpha) or g, as it is or as its reciprocal. `impacts` is 0 or 1.
std::vector<Reading> threshold_readings(Bench& bench, double omega_ratio, int impacts);
/// T_ex = (2 pi - psi)/(omega_p/p * p) with sin(psi) = 1/amplitude: 2 pi exact or 6.28, psi exact or with
/// pi = 3.14 in it, the amplitude as printed or the least one computed; and the period 2 pi/omega_p.
std::vector<Reading> period_readings(Bench& bench, double omega_ratio, double printed_amplitude);
/// Where the impact passes the end of the pulse, and where overturning after one impact ends.
std::vector<Reading> handover_readings(Bench& bench);
std::vector<Reading> end_readings(Bench& bench);

}  // namespace rederive::rocking_block
