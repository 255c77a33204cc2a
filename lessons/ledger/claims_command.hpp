// `ledger claims [ID] [--json]`.
#pragma once

#include <string>

namespace rederive {

/// Decides all claims, or the one with that id, and writes them to standard output. Returns the exit code: 1
/// if a verdict differs from the expected one. Throws BadInput for an id that does not exist.
int show_claims(const std::string& file, const std::string& id, bool json);

}  // namespace rederive
