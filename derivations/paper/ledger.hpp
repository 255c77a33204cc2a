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

/// A part of a row with its verdict; see RowPart.
struct JudgedPart {
  RowPart part;
  std::string derived;
  decide::Verdict verdict;
};

/// A row with its verdict. If the row has parts, `row.printed` and what else is here are those of the part
/// that says most against it.
struct Entry {
  Row row;
  std::optional<mechanics::Derivation> derivation;  ///< none for definitions
  decide::Proof proof;
  std::optional<mechanics::DimensionReport> dimension;  ///< none where nothing is printed
  std::string derived, correction;                      ///< in our syntax; correction only with refuted
  std::vector<JudgedPart> parts = {};                   ///< empty if the row is one statement
  /// Whether the row is proved by a derivation that only states it.
  bool is_stated() const {
    return derivation && derivation->is_stated && proof.verdict != decide::Verdict::refuted;
  }
};

/// Returns the symbols of the paper, with the ranges that the domain of a row narrows: "theta < 0" makes 0
/// the upper end of the range of θ. Commas separate several relations. Throws std::invalid_argument for a
/// domain of another form.
language::Symbols symbols_in(const Paper& paper, const std::string& domain);

/// Returns the entry of a row: derives it, compares it with the printed form and checks the dimensions.
/// The verdict is `error` if the row cannot be read, or its derivation cannot be used. A statement with ± has
/// the derivations ID[+] and ID[-]; if there are none, both signs, or both as one equation of second degree,
/// are compared with the derivation of the row.
Entry judge(const Paper& paper, const Row& row);
/// Returns the entry of the row with the given id. Throws std::out_of_range, with the id, if there is none.
Entry judged(const Paper& paper, const std::string& id);

/// Returns the id of the derivation of a part: "7[1,2]", or "7" of a sign that has none of its own.
std::string derivation_id(const Paper& paper, const Row& row, const RowPart& part);

/// Returns the derivation `id` of a row, or std::nullopt if none is listed, with what the row says of the
/// order and assumes. Throws std::runtime_error, with the place and the reason, if the derivation throws or
/// contains something that cannot be judged: an undeclared symbol, a number that is not rational, or a form
/// that our syntax lacks; or if the row and the derivation name different orders.
std::optional<mechanics::Derivation> checked_derivation(const Paper& paper, const Row& row,
                                                        const std::string& id);

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
/// derivation has an order and the two differ, it compares their series to that order. Symbols in `integers`
/// are whole numbers: (-1)^n, and waves of multiples of pi, are decided for each remainder of n, and a
/// witness has a whole n.
decide::Proof compare(const language::Relation& printed, const mechanics::Derivation& derivation,
                      const language::Symbols& symbols,
                      const std::vector<language::Relation>& conditions = {},
                      const std::vector<std::string>& integers = {});

}  // namespace rederive::paper
