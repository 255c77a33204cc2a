// Phases with denominators: α, α/(1+p) and αp/(1+p) are two independent ones, not three.
#pragma once

#include <ginac/ginac.h>

#include <map>
#include <vector>

namespace rederive {

/// A sum of monomials, as coefficients.
using Monomials = std::map<GiNaC::ex, GiNaC::numeric, GiNaC::ex_is_less>;

/// Linearly independent phases over the rational numbers, each given by its monomials over a denominator that
/// all of them share.
class PhaseBasis {
 public:
  /// Adds a phase, if it is no combination of those before.
  void add(const GiNaC::ex& phase, const Monomials& monomials);
  /// The coefficients of the phases in a combination of them. Throws std::out_of_range where it is none.
  std::vector<GiNaC::numeric> coefficients(const Monomials& monomials) const;

  /// Those that were added and are independent, in that order: the order of coefficients(), too.
  const std::vector<GiNaC::ex>& phases() const { return phases_; }

 private:
  /// monomials = Σ combination[k]·phase k, and no row after it has this pivot.
  struct Row {
    GiNaC::ex pivot;
    Monomials monomials;
    std::vector<GiNaC::numeric> combination;
  };
  /// What is left after the rows have been taken off, and how often each phase was.
  std::vector<GiNaC::numeric> take_off(Monomials& monomials) const;

  std::vector<GiNaC::ex> phases_;
  std::vector<Row> rows_;
};

}  // namespace rederive
