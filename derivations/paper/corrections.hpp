// What a refuted row should say.
#pragma once

#include <derivations/paper/ledger.hpp>

namespace rederive::paper {

/// A correction of what is printed, in our syntax: the printed form with one argument of a function changed,
/// where that is proved to be right and shorter than what is derived; else what is derived. `conditions` as
/// of `compare`.
std::string correction_of(const Paper& paper, const language::Relation& printed,
                          const mechanics::Derivation& derivation, const language::Symbols& symbols,
                          const std::vector<language::Relation>& conditions);

}  // namespace rederive::paper
