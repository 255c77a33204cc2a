// What follows from the links of a statement, so that an identity of polynomials shows it.
#pragma once

#include <derivations/algebra/residuals.hpp>

namespace rederive {

/// What one link asks for.
struct Asked {
  GiNaC::ex residual;
  Claim claim;
};

/// A product of residuals of links, by their numbers, with a factor: 0 where one of the links is an equation;
/// else not negative, for the factor is not; positive, where all of them are.
struct Summand {
  GiNaC::ex factor;
  std::vector<std::size_t> links;
};

/// times·r = Σ terms + more with `more` >= 0 says of a residual r
///   r = 0    if all terms have equations, more is 0 and times is never 0 where the divisors are not,
///   r >= 0   if times > 0,
///   r > 0    if times >= 0 and a term or more is positive;
/// for factors, times and more have a value wherever the statement has one: they divide by nothing. The same
/// with -r² in the place of r: r = 0, and so r >= 0, if times > 0.
struct Consequence {
  std::vector<Summand> terms;
  GiNaC::ex more = 0, times = 1;
  bool squared = false;
};

/// Whether all of that is so: the identity, and every sign. Throws Undecidable.
bool shows(const Consequence& why, const Asked& target, const std::vector<Asked>& links,
           const std::vector<GiNaC::ex>& divisors, const Symbols& symbols);

/// Whether both statements have a value at the same points, for they divide by the same and have the same
/// roots and logarithms, as far as the declared ranges leave it open; or one divides by a symbol that is not
/// 0 where the other one holds.
bool have_values_together(const std::vector<Asked>& left, const std::vector<Asked>& right,
                          const Residuals& divisors, const Symbols& symbols);

/// Why what one link asks for follows from those of the other statement, looked over by `shows`, where what
/// the two divide by is not 0. Nothing where that is not seen.
std::optional<Consequence> consequence(const Asked& target, const std::vector<Asked>& links,
                                       const std::vector<GiNaC::ex>& divisors, const Symbols& symbols);

}  // namespace rederive
