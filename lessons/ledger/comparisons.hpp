// Assumptions that compare symbols: b < h is h = b + excess with a positive excess, x + y > 0 is x = -y +
// excess.
#pragma once

#include <derivations/algebra/prove.hpp>
#include <lessons/ledger/inequalities.hpp>
#include <optional>

namespace rederive {

/// What a comparison is replaced by.
struct Comparison {
  Given given;          ///< one symbol as the other side and the excess
  std::string excess;   ///< the name of a symbol of its own, positive or not negative
  std::string meaning;  ///< the excess in the symbols that were compared: "h - b"
};

/// How the two sides of an inequality compare after those before: +1 if it always holds, -1 if never, 0 if
/// neither is known.
int settled_by(const std::vector<Comparison>& before, const Inequality& inequality, const Symbols& symbols);

/// Declares the excess over what the inequality, after those before it, says of one symbol: linear in it,
/// with a factor of known sign, better with a range that follows from the bound. Nothing where there is none.
std::optional<Comparison> compared(const Inequality& inequality, const std::vector<Comparison>& before,
                                   Symbols& symbols);

/// An expression, or an equation "… = 0", in the symbols that the user knows.
std::string without_excess(std::string text, const std::vector<Comparison>& comparisons,
                           const Symbols& symbols);

/// The same proof in the symbols that the user knows; the witness with all of them.
Proof without_excess(Proof proof, const std::vector<Comparison>& comparisons, const Symbols& symbols);

}  // namespace rederive
