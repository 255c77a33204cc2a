// What is not negative because its square shows it: a - b, where a >= 0 and a^2 >= b^2.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>
#include <vector>

namespace rederive {

/// Why an expression is not negative: with r = a - b, a >= 0 and a^2 - b^2 >= 0, which may be so by its own
/// square in turn.
struct InSquare {
  std::vector<GiNaC::ex> roots;  ///< a of the expression, of a^2 - b^2 …
  GiNaC::ex rest;                ///< … and the last a^2 - b^2, which is 0 or of known sign
  bool is_strict;                ///< it is positive, and with it the expression
};

/// Of a sum in which square roots or absolute values are among the terms that are not negative: they make up
/// a, as in fabs(x) + fabs(y) - fabs(x + y) or sqrt(A^2 + B^2) - A sin x. Nothing where two squares do not
/// show it.
std::optional<InSquare> shown_in_square(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive
