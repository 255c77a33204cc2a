// Sums that are quadratic in a symbol or in its square.
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>

namespace rederive {

/// a x² + b x + c, where x is one of its symbols or the square of one. Where its discriminant, 4ac - b² here,
/// is not negative, it keeps the sign of a.
struct Quadratic {
  GiNaC::ex x, a, b, c;
  GiNaC::ex discriminant() const { return (4 * a * c - b * b).expand(); }
};
/// In the first symbol of the alphabet in which it is one, one that may have either sign before others: then
/// the discriminant is made of those whose sign is known. Nothing for what is no sum, or a long one.
std::optional<Quadratic> as_quadratic(const GiNaC::ex& expression, const Symbols& symbols);

}  // namespace rederive
