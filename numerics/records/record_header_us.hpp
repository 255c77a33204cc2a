// The headers of files from the United States: SMC of the USGS, and COSMOS.
#pragma once

#include <numerics/records/record_header_fields.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive::numerics {

/// Returns the SMC header that `lines` begin with, or nothing for other files. Throws as `record_header`
/// does.
std::optional<RecordHeader> smc_header(const std::vector<std::string>& lines, const std::string& file);

/// Returns the COSMOS 1.20 header that `lines` begin with, or nothing for other files. Throws as
/// `record_header` does.
std::optional<RecordHeader> cosmos_header(const std::vector<std::string>& lines, const std::string& file);

}  // namespace rederive::numerics
