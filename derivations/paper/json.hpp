// What is found, as JSON: the fields that every program writes.
#pragma once

#include <derivations/paper/ledger.hpp>
#include <nlohmann/json_fwd.hpp>

namespace rederive::paper {

/// A row of `ledger --json`.
nlohmann::ordered_json to_json(const Entry& entry);
/// Returns what `ledger prove --json` prints.
nlohmann::ordered_json to_json(const decide::Proof& proof);

/// Returns "consistent", "inconsistent", or "not_applicable" for a row of which nothing is printed.
std::string dimension_word(const Entry& entry);

}  // namespace rederive::paper
