// Each row from the rows that it follows from.
#pragma once

#include <derivations/kernel/scripts.hpp>
#include <functional>

namespace rederive {

/// Which rows are wanted, by their numbers.
using Wanted = std::function<bool(const std::string& id)>;

/// A lemma for every wanted row that follows by algebra from the rows before it: what these say are
/// hypotheses, and either the row is an equation between what they make equal, or one of them, under the
/// others, says the same as the row. Not those that differentiate, integrate or go to a moment.
std::vector<Lemma> steps_of(const Paper& paper, const std::vector<Entry>& entries, const Wanted& wanted);

/// For each wanted row that is refuted: the correction that the ledger prints says what was derived.
std::vector<Lemma> corrections_of(const Paper& paper, const std::vector<Entry>& entries,
                                  const Wanted& wanted);

}  // namespace rederive
