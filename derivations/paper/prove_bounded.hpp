// `ledger prove`: the decision procedure on anything that a user types, within bounds.
#pragma once

#include <derivations/paper/prove.hpp>
#include <functional>
#include <nlohmann/json_fwd.hpp>

namespace rederive {

/// Decides within two seconds and 500 MB; where the machine has less than half a processor for it, in more,
/// but not in more than `patience` seconds, and not when `stop` says so. The proof as `ledger prove --json`
/// has it. Throws BadInput (with a caret) for what cannot be read.
nlohmann::ordered_json decide_bounded(const ProveRequest& request, double patience = 60,
                                      const std::function<bool()>& stop = {});

}  // namespace rederive
