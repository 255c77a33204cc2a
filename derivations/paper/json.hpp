// What is found, as JSON: the fields that every program writes.
#pragma once

#include <derivations/paper/ledger.hpp>
#include <nlohmann/json_fwd.hpp>

namespace rederive::paper {

/// A row of `ledger --json`.
nlohmann::ordered_json to_json(const Entry& entry);
/// What `ledger prove --json` prints.
nlohmann::ordered_json to_json(const decide::Proof& proof);

/// "consistent", "inconsistent"; "not_applicable" where nothing is printed.
std::string dimension_word(const Entry& entry);

}  // namespace rederive::paper
