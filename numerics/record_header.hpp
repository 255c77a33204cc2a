// What the header of a published ground-motion file says of its values.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace rederive::inline numeric {

struct RecordHeader {
  std::size_t first = 0;  ///< index of the first line of values
  std::size_t width = 0;  ///< characters a value where values may run together, or 0
  double step = 0;        ///< seconds
  double count = 0;       ///< how many values there must be
  std::string counted;    ///< what says so: "NPTS"
  double to_g = 1;        ///< one unit of the values in g
  bool offset = false;    ///< the values stand about an unknown level
};

/// Throws std::invalid_argument: "file:line: why".
[[noreturn]] void refuse(const std::string& file, std::size_t line, std::string why);

/// The header of PEER AT2 (four lines), K-NET or KiK-net ASCII ("Origin Time" to "Memo.", NIED) or ESM ASCII
/// (lines "KEY: value", DYNA 1.2); none for other files. Throws std::invalid_argument with file and line for
/// one without a usable time step, count or unit of acceleration.
std::optional<RecordHeader> record_header(const std::vector<std::string>& lines, const std::string& file);

}  // namespace rederive::inline numeric
