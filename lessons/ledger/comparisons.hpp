// Assumptions that compare symbols: b < h is h = b + excess with a positive excess.
#pragma once

#include <derivations/algebra/prove.hpp>
#include <optional>

namespace rederive {

/// What a comparison is replaced by.
struct Comparison {
  Given given;          ///< one symbol as the other side and the excess
  std::string excess;   ///< the name of a symbol of its own, positive or not negative
  std::string meaning;  ///< the excess in the symbols that were compared: "h - b"
};

/// How the two sides of an inequality compare after those before: +1 if it always holds, -1 if never, 0 if
/// neither is known. Throws SyntaxError.
int settled_by(const std::vector<Comparison>& before, const Relation& inequality, const Symbols& symbols);

/// Declares the excess. The symbol that is replaced stands alone on one side, is none that was replaced
/// before, and the other side is a polynomial without it. Nothing where there is none. Throws SyntaxError.
std::optional<Comparison> compared(const Relation& inequality, const std::vector<Comparison>& before,
                                   Symbols& symbols);

/// The same proof in the symbols that the user knows; the witness with all of them.
Proof without_excess(Proof proof, const std::vector<Comparison>& comparisons, const Symbols& symbols);

}  // namespace rederive
