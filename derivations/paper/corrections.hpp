// What a refuted row should say.
#pragma once

#include <derivations/paper/ledger.hpp>

namespace rederive {

/// A correction of what is printed, in our syntax: the printed form with one argument of a function changed,
/// where that is proved to be right and shorter than what is derived; else what is derived. `conditions` as
/// of `compare`.
std::string correction_of(const Paper& paper, const Relation& printed, const Derivation& derivation,
                          const Symbols& symbols, const std::vector<Relation>& conditions);

}  // namespace rederive
