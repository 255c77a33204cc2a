// What the header of a published ground-motion file says of its values.
#pragma once

#include <cstddef>
#include <numerics/records/record_numbers.hpp>
#include <numerics/records/record_text.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::numerics {

struct RecordHeader {
  std::size_t first = 0;      ///< index of the first line of values
  std::size_t width = 0;      ///< characters a value where values may run together, or 0
  double step = 0;            ///< seconds
  double count = 0;           ///< how many values there must be
  std::string counted = {};   ///< what says so: "NPTS"
  double to_g = 1;            ///< one unit of the values in g
  bool offset = false;        ///< the values are counts about an unknown level
  std::string end_mark = {};  ///< how the line behind the last value begins, or ""
};

/// The header of PEER AT2, K-NET or KiK-net ASCII ("Origin Time" to "Memo.", NIED), ESM ASCII (lines
/// "KEY: value", DYNA 1.2), SMC (USGS) or COSMOS 1.20; none for other files. Throws std::invalid_argument
/// with file and line for one without a usable time step, count or unit of acceleration, or of another
/// quantity.
std::optional<RecordHeader> record_header(const std::vector<std::string>& lines, const std::string& file);

std::optional<RecordHeader> smc_header(const std::vector<std::string>& lines, const std::string& file);
std::optional<RecordHeader> cosmos_header(const std::vector<std::string>& lines, const std::string& file);

// For the readers of headers. A line is counted from 1.

/// The line without what no header needs: it may be of any length, and std::regex recurses.
std::string head_of(const std::string& line);
std::string upper(std::string text);
/// A number above 0, at most 1e9; a whole one; throw std::invalid_argument for others.
double positive(const std::string& text, const std::string& name, const std::string& file, std::size_t line);
double whole(const std::string& text, const std::string& name, const std::string& file, std::size_t line);
double checked_step(double step, const std::string& file, std::size_t line);
/// One unit of acceleration in g.
double unit_in_g(const std::string& unit, const std::string& file, std::size_t line);
/// Refuses a description of the values, such as "VELOCITY TIME SERIES", that is not of accelerations.
void check_quantity(const std::string& description, const std::string& file, std::size_t line);

}  // namespace rederive::numerics
