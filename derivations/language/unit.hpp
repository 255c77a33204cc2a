// Units of the SI, as text and as exponents of kg, m, s.
#pragma once

#include <ginac/ginac.h>

#include <array>
#include <string>
#include <string_view>

namespace rederive {

/// Exponents of kg, m, s.
using Dimension = std::array<GiNaC::numeric, 3>;

/// "kg·m²/s²"; "1" for a pure number.
std::string unit_text(const Dimension& dimension);
/// Reads "kg*m^2/s^2" or "1". Throws std::invalid_argument.
Dimension parse_unit(std::string_view text);

}  // namespace rederive
