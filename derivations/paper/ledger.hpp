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

namespace rederive {

/// A row, judged.
struct Entry {
  Row row;
  std::optional<Derivation> derivation;  ///< none for definitions
  Proof proof;
  std::optional<DimensionReport> dimension;  ///< none where nothing is printed
  std::string derived, correction;           ///< in our syntax; correction only with refuted
  std::vector<std::string> rests_on_it;      ///< ids of the rows downstream, in the paper's order
};

/// The symbols of the paper with the row's domain put in: "theta < 0" makes 0 the upper end of the range of
/// θ; several relations are separated by commas. Throws std::invalid_argument for a domain of another form.
Symbols symbols_in(const Paper& paper, const std::string& domain);

/// Judges one row: derives, compares, checks dimensions. `rows` gives what rests on it. Where the derivation
/// cannot be used the verdict is error. Throws SyntaxError where the printed text cannot be read.
Entry judge(const Paper& paper, const Row& row, const std::vector<Row>& rows);
/// The entry of a row of the paper, judged now. Throws std::out_of_range naming the id if there is none.
Entry judged(const Paper& paper, const std::string& id);

/// The derivation of an equation by its id, nullopt if none is listed. Throws std::runtime_error, saying why
/// and where, if it throws, or holds what cannot be judged: a symbol that is not declared, a number that is
/// not rational.
std::optional<Derivation> checked_derivation(const Paper& paper, const std::string& id);

/// What was derived for a row, as a relation that can be printed and compared.
Relation derived_relation(const Derivation& derivation, const Symbols& symbols);

/// What holds where a row is compared with its derivation, beside the numeric ranges of the symbols: what the
/// domain and the ranges say of several symbols ("theta_0 < alpha"), and what the derivation assumes. `claim`
/// is what the row claims, read with `symbols`. Throws std::invalid_argument for an assumption that cannot be
/// read.
std::vector<Relation> conditions_of(const Paper& paper, const Row& row, const Relation& claim,
                                    const Derivation& derivation, const Symbols& symbols);

/// Whether a printed relation says what was derived: the comparison that `judge` makes, for a mutant or an
/// answer. Where a derivation has an order and the two are not the same, their series are compared.
Proof compare(const Relation& printed, const Derivation& derivation, const Symbols& symbols,
              const std::vector<Relation>& conditions = {});

}  // namespace rederive
