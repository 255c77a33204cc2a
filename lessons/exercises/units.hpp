// Numbers with units as students type them: "2.14 1/s", "35 cm", "14.3 deg", "1.5 m - 1.47 m".
#pragma once

#include <derivations/mechanics/dimension.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rederive::classroom {

struct Quantity {
  double value = 0;                               ///< in SI units; angles in radians
  std::optional<mechanics::Dimension> dimension;  ///< nothing where no unit was typed
  std::string read_as;                            ///< reads back as the same quantity
  int digits = 0;         ///< how many significant ones were typed; 0 unless it is a plain decimal number
  bool in_turns = false;  ///< the unit is Hz, which counts whole turns
};

/// Reads a number with a unit. Each term of a sum has its own unit, or the last term has the unit of the
/// whole sum: 1.5 - 1.47 m is 0.03 m. Throws SyntaxError if a number or a unit cannot be read, if terms have
/// different units, and for 90 - 30 deg, which has two readings.
Quantity parse_quantity(const std::string& text);
/// Returns all readings of a number with a unit, and what is not clear if there are several.
std::pair<std::vector<Quantity>, std::string> quantities_in(const std::string& text);
/// Returns whether a text is a unit: "kg*m^2".
bool is_unit(const std::string& text);

}  // namespace rederive::classroom
