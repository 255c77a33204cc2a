// The ledger as tables, JSON, an errata sheet and a graph.
#pragma once

#include <derivations/paper/json.hpp>
#include <derivations/paper/ledger.hpp>
#include <derivations/paper/prove.hpp>
#include <nlohmann/json_fwd.hpp>

namespace rederive::ledger {

/// Returns the whole ledger as one JSON document: paper, equations, counts.
nlohmann::ordered_json to_json(const std::vector<paper::Entry>& entries, const paper::Paper& paper);

/// Returns one line for each row, and counts by verdict at the end; with colours if `colour` is true.
std::string ledger_table(const std::vector<paper::Entry>& entries, const language::Symbols& symbols,
                         bool colour);
/// Returns everything about one row as text: printed, derived with its steps, verdict, witness, consequence.
std::string ledger_page(const paper::Entry& entry, const language::Symbols& symbols, bool colour);
/// Returns the refuted rows, those on which most other rows rest first. `format` is "text", "markdown",
/// "html", "latex" or "json".
std::string errata(const std::vector<paper::Entry>& entries, const std::string& format,
                   const paper::Paper& paper);
/// Returns the derivation graph in DOT, coloured by verdict.
std::string graph(const std::vector<paper::Entry>& entries);

/// Returns how many rows have each verdict.
std::map<std::string, int> counts(const std::vector<paper::Entry>& entries);

}  // namespace rederive::ledger
