// The claims of the text of the built-in paper, and how each is decided.
#pragma once

#include <lessons/ledger/claims.hpp>

namespace rederive::rocking_block {

/// Returns the file claims.toml beside the rows, with its checks (claims_bench.hpp). The checks share a
/// bench, which keeps what is expensive.
ledger::Claims claims();

}  // namespace rederive::rocking_block
