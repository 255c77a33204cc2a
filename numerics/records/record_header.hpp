// The headers of published ground-motion files.
#pragma once

#include <numerics/records/record_header_fields.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::numerics {

/// Returns the header that `lines` begin with: PEER AT2, K-NET or KiK-net ASCII ("Origin Time" to "Memo.",
/// NIED), ESM ASCII (lines "KEY: value", DYNA 1.2), SMC (USGS) or COSMOS 1.20; nothing for other files.
/// Throws std::invalid_argument with `file` and the line if the header lacks a usable time step, count or
/// unit of acceleration, or describes another quantity.
std::optional<RecordHeader> record_header(const std::vector<std::string>& lines, const std::string& file);

}  // namespace rederive::numerics
