// What the readers of published headers share: the values that a header promises, and its numbers and units.
#pragma once

#include <cstddef>
#include <numerics/records/record_numbers.hpp>
#include <numerics/records/record_text.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::numerics {

/// What the header of a file says about the values behind it.
struct RecordHeader {
  std::size_t first = 0;      ///< index of the first line of values
  std::size_t width = 0;      ///< characters of a value where values may run together, or 0
  double step = 0;            ///< seconds between two values
  double count = 0;           ///< the number of values that the file must have
  std::string counted = {};   ///< the name of the field that gives it: "NPTS"
  double to_g = 1;            ///< one unit of the values in g
  bool offset = false;        ///< the values are counts with an unknown zero level
  std::string end_mark = {};  ///< how the line behind the last value begins, or ""
};

// In the following functions `file` and `line` (counted from 1) are those that an error names.

/// Returns the first 200 characters of a line: no header needs more, and std::regex recurses on long lines.
std::string head_of(const std::string& line);
/// Returns the text with a to z as capitals.
std::string upper(std::string text);
/// Returns the number that `text` is. Throws std::invalid_argument unless it is above 0 and at most 1e9.
double positive(const std::string& text, const std::string& name, const std::string& file, std::size_t line);
/// Returns the whole number that `text` is. Throws as `positive` does, and for other numbers.
double whole(const std::string& text, const std::string& name, const std::string& file, std::size_t line);
/// Returns `step`, in seconds. Throws std::invalid_argument unless it is from 1e-9 to 1e6.
double checked_step(double step, const std::string& file, std::size_t line);
/// Returns one unit of acceleration in g. Throws std::invalid_argument for other units.
double unit_in_g(const std::string& unit, const std::string& file, std::size_t line);
/// Throws std::invalid_argument if a description such as "VELOCITY TIME SERIES" names another quantity than
/// acceleration.
void check_quantity(const std::string& description, const std::string& file, std::size_t line);

}  // namespace rederive::numerics
