// Arguments of circular functions, or of exponentials, as whole multiples of independent phases.
#pragma once

#include <derivations/identity/polynomial.hpp>
#include <map>
#include <string>
#include <vector>

namespace rederive {

/// A combination of terms, each a fraction of the ring that no other one is a rational multiple of.
using Combination = std::map<std::string, std::pair<Fraction, cln::cl_RA>>;  ///< key → (term, coefficient)

/// phase · multiple, summed, is the argument; the phases are linearly independent over the rationals.
struct Multiple {
  std::string key;  ///< of phase/divisor
  Fraction phase;   ///< already divided
  int times;
};

class PhaseBasis {
 public:
  /// The argument in the basis; nothing where a basis that has it must be made first.
  std::optional<std::vector<Multiple>> multiples(const Combination& argument) const;
  /// Takes an argument in; true if that is a new one.
  bool add(const Combination& argument);
  /// Phases for all arguments that were taken in: the terms, or the arguments themselves where these are
  /// fewer (all multiples of α + θ need one phase, not two); each divided so that all multiples are whole.
  /// `each_term`: in any case the terms.
  void rebuild(bool each_term);

 private:
  std::optional<std::vector<cln::cl_RA>> coordinates(const Combination& argument) const;
  std::vector<Combination> arguments_, basis_;
  std::vector<cln::cl_I> divisors_;
};

}  // namespace rederive
