// Checks that all terms of an equation have the same dimension.
#pragma once

#include <array>
#include <derivations/language/symbols.hpp>
#include <derivations/language/tree.hpp>
#include <optional>
#include <string>

namespace rederive::mechanics {

/// The base units of the SI.
inline constexpr std::array<const char*, 7> base_units = {"kg", "m", "s", "A", "K", "mol", "cd"};
/// The exponents of the base units, in the order of `base_units`.
using Dimension = std::array<GiNaC::numeric, base_units.size()>;
/// Returns the dimension of a product of powers of units in our syntax: "kg*m^2/s^2", "s^4/(kg*m^2)",
/// "kg^-1", "N/m", "rad/s", "1". The units are the base units, N, J, W, Pa, Hz, V and rad, which is 1. These
/// names do not clash with symbols, which no unit contains. Throws std::invalid_argument for other texts.
Dimension parse_unit(std::string_view text);

/// Returns a dimension as text: "kg·m²/s²", or "1" for a pure number.
std::string unit_text(const Dimension& dimension);

struct DimensionReport {
  bool consistent;
  std::optional<Dimension> dimension;  ///< of the whole, if consistent; none if any fits (a bare 0)
  std::string explanation;             ///< "term 3 is kg·m²/s, the others kg·m²/s²"; empty if consistent
};

/// Returns whether all terms have the same dimension. Angles are pure numbers; arguments of sin, exp … must
/// be pure numbers. Throws SyntaxError for an exponent without a value, and std::invalid_argument for a unit
/// of a symbol that cannot be read.
DimensionReport dimension(const language::Tree& tree, const language::Symbols& symbols);
DimensionReport dimension(const language::Relation& relation, const language::Symbols& symbols);

}  // namespace rederive::mechanics
