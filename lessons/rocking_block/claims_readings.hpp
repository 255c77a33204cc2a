// Finds the reading of a printed number that reproduces it. A reading is a named convention; nothing is
// fitted.
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

/// A reading compared with a printed number; `off` is the difference in units of its last digit.
struct Match {
  Reading reading;
  double off = 0;
  bool rounds = false;  ///< gives the printed digits when rounded
};

/// Returns the readings by their distance from a printed number such as "0.672", the nearest first. The
/// digits after its point set the unit of the distance.
std::vector<Match> compare_with(const std::string& printed, const std::vector<Reading>& readings);
/// Returns the readings that lie between two printed numbers.
std::vector<Reading> between(const std::string& one, const std::string& other,
                             const std::vector<Reading>& readings);

/// Returns "fits: …" with all readings that round to the number, or "none of N readings fits; nearest …".
std::string summary(const std::vector<Match>& matches);
/// Returns the readings that round to the printed number.
std::vector<Reading> fitting(const std::vector<Match>& matches);

/// Returns all readings of a threshold: linear or nonlinear, alpha = 0.25 or atan(0.25), e of (46), 0.9 or 1,
/// in alpha*g, g*tan(alpha) or g, as it is or as its reciprocal. `impacts` is 0 or 1.
std::vector<Reading> threshold_readings(Bench& bench, double omega_ratio, int impacts);
/// Returns all readings of T_ex = (2 pi - psi)/(omega_p/p * p), in s, with sin(psi) = 1/amplitude: 2 pi exact
/// or 6.28, psi exact or with pi = 3.14 in it, the amplitude as printed or the least one computed; and the
/// period 2 pi/omega_p.
std::vector<Reading> period_readings(Bench& bench, double omega_ratio, double printed_amplitude);
/// Return all readings of omega_p/p at which the impact passes the end of the pulse, and at which overturning
/// after one impact ends.
std::vector<Reading> handover_readings(Bench& bench);
std::vector<Reading> end_readings(Bench& bench);

}  // namespace rederive::rocking_block
