// The ledger: the paper as printed, beside what is derived, with a verdict computed on every call.
#pragma once

#include <derivations/decide/decide.hpp>
#include <derivations/mechanics/derivation.hpp>
#include <derivations/paper/paper.hpp>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rederive::paper {

/// A row with its verdict.
struct Entry {
  Row row;
  std::optional<mechanics::Derivation> derivation;  ///< none for definitions
  decide::Proof proof;
  std::optional<mechanics::DimensionReport> dimension;  ///< none where nothing is printed
  std::string derived, correction;                      ///< in our syntax; correction only with refuted
};

/// Returns the symbols of the paper, with the ranges that the domain of a row narrows: "theta < 0" makes 0
/// the upper end of the range of θ. Commas separate several relations. Throws std::invalid_argument for a
/// domain of another form.
language::Symbols symbols_in(const Paper& paper, const std::string& domain);

/// Returns the entry of a row: derives it, compares it with the printed form and checks the dimensions.
/// The verdict is `error` if the derivation cannot be used. Throws SyntaxError if the printed text cannot be
/// read.
Entry judge(const Paper& paper, const Row& row);
/// Returns the entry of the row with the given id. Throws std::out_of_range, with the id, if there is none.
Entry judged(const Paper& paper, const std::string& id);

/// Returns the derivation of the row with the given id, or std::nullopt if none is listed. Throws
/// std::runtime_error, with the place and the reason, if the derivation throws or contains something that
/// cannot be judged: an undeclared symbol, a number that is not rational, or a form that our syntax lacks.
std::optional<mechanics::Derivation> checked_derivation(const Paper& paper, const std::string& id);

/// Returns the result of a derivation as a relation that can be printed and compared.
language::Relation derived_relation(const mechanics::Derivation& derivation,
                                    const language::Symbols& symbols);

/// Returns the conditions under which a row is compared with its derivation, beside the numeric ranges of the
/// symbols: the relations between symbols that the domain and the ranges state ("theta_0 < alpha"), and the
/// assumptions of the derivation. `claim` is the claim of the row, read with `symbols`. Throws
/// std::invalid_argument for an assumption that cannot be read.
std::vector<language::Relation> conditions_of(const Paper& paper, const Row& row,
                                              const language::Relation& claim,
                                              const mechanics::Derivation& derivation,
                                              const language::Symbols& symbols);

/// Compares a printed relation with a derivation, as `judge` does, also for a mutant or an answer. If the
/// derivation has an order and the two differ, it compares their series to that order.
decide::Proof compare(const language::Relation& printed, const mechanics::Derivation& derivation,
                      const language::Symbols& symbols,
                      const std::vector<language::Relation>& conditions = {});

}  // namespace rederive::paper
