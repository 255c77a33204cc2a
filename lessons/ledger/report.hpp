// The ledger as tables, JSON, an errata sheet and a graph.
#pragma once

#include <derivations/paper/json.hpp>
#include <derivations/paper/ledger.hpp>
#include <derivations/paper/prove.hpp>
#include <nlohmann/json_fwd.hpp>

namespace rederive {

/// The whole ledger in one JSON document, as COMMANDS fixes it: paper, equations, counts.
nlohmann::ordered_json to_json(const std::vector<Entry>& entries, const Paper& paper);

/// A row an equation, counts by verdict at the end. `colour` for terminals.
std::string ledger_table(const std::vector<Entry>& entries, const Symbols& symbols, bool colour);
/// All about one row, for a reader: printed, derived with its steps, verdict, witness, consequence.
std::string ledger_page(const Entry& entry, const Symbols& symbols, bool colour);
/// The refuted rows alone, those with most resting on them first: "text", "markdown", "latex" or "json".
std::string errata(const std::vector<Entry>& entries, const std::string& format, const Paper& paper);
/// The derivation graph in DOT, coloured by verdict.
std::string graph(const std::vector<Entry>& entries);

/// Verdict → how many.
std::map<std::string, int> counts(const std::vector<Entry>& entries);

}  // namespace rederive
