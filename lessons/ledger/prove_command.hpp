// `ledger prove`: the decision procedure on anything that a user types, within bounds.
#pragma once

#include <derivations/decide/decide.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace rederive {

/// What was asked.
struct ProveRequest {
  std::string left, right;
  std::vector<std::string> assumptions;  ///< "x > 0", "0 < x < 1", "b < h", "x != 0", "theta = 0"
  std::vector<std::string> small;        ///< expansion symbols, with order
  std::optional<int> order;              ///< compare the series up to this order
};

/// The symbols of the paper, and every letter and Greek letter (with an index or dots) that the texts use. t,
/// r and d are any real numbers: everybody uses them for something else than the paper does.
Symbols declared_symbols(const ProveRequest& request);

/// Decides. Among the side conditions are the declared ranges and the assumed inequalities without which the
/// proof does not go through. Throws BadInput (with a caret) for what cannot be read, and for assumptions
/// that contradict each other.
Proof decide(const ProveRequest& request);

/// Decides within two seconds and 500 MB; where the machine has less than half a processor for it, in more,
/// but not in more than `patience` seconds. The proof as `ledger prove --json` has it. Throws BadInput (with
/// a caret) for what cannot be read.
nlohmann::ordered_json decide_bounded(const ProveRequest& request, double patience = 60);

}  // namespace rederive
