// `ledger prove`: the decision procedure on anything that a user types, within bounds.
#pragma once

#include <derivations/paper/prove.hpp>
#include <functional>
#include <nlohmann/json_fwd.hpp>

namespace rederive::paper {

/// Decides within two seconds of processor time and 500 MB. It is given up when `stop` says so. The proof as
/// `ledger prove --json` has it. Throws BadInput (with a caret) for what cannot be read.
nlohmann::ordered_json decide_bounded(const Paper& paper, const ProveRequest& request,
                                      const std::function<bool()>& stop = {});

}  // namespace rederive::paper
