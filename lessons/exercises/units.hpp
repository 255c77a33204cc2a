// Numbers with units as students type them: "2.14 1/s", "35 cm", "14.3 deg", "sqrt(3)/2 m/s".
#pragma once

#include <derivations/rocking_block/paper_symbols.hpp>
#include <optional>
#include <string>

namespace rederive::classroom {

struct Quantity {
  double value;                        ///< in SI units; angles in radians
  std::optional<Dimension> dimension;  ///< nothing where no unit was typed
  std::string read_as;
  int digits = 0;  ///< how many significant ones were typed; 0 if it is no plain decimal number
};

/// Reads a number and a unit. Throws SyntaxError where either cannot be read.
Quantity parse_quantity(const std::string& text);
/// Whether a text is a unit: "kg*m^2".
bool is_unit(const std::string& text);

}  // namespace rederive::classroom
