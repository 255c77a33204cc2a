// Lemmas that derive a row from the rows before it.
#pragma once

#include <derivations/kernel/scripts.hpp>
#include <functional>

namespace rederive::ledger {

/// Says whether a row is to have a lemma.
using Wanted = std::function<bool(const std::string& id)>;

/// Returns a lemma for every wanted row that follows by algebra from the rows before it. These rows are the
/// hypotheses. Either the row is an equation between two sides that they make equal, or one of them says the
/// same as the row under the others. Rows that follow by differentiation, by integration or at one moment
/// have no such lemma.
std::vector<kernel::Lemma> steps_of(const paper::Paper& paper, const std::vector<paper::Entry>& entries,
                                    const Wanted& wanted);

/// Returns a lemma for each wanted row that is refuted: the correction in the ledger says what was derived.
std::vector<kernel::Lemma> corrections_of(const paper::Paper& paper, const std::vector<paper::Entry>& entries,
                                          const Wanted& wanted);

}  // namespace rederive::ledger
