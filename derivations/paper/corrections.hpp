// What a refuted row should say.
#pragma once

#include <derivations/paper/ledger.hpp>

namespace rederive::paper {

/// Returns a correction of what is printed, in our syntax: the printed form with one term, factor, sign,
/// argument, function or symbol changed, where that is proved to be right; else what is derived. The search
/// is that of the classroom (repairs.hpp). `conditions` as of `compare`.
std::string correction_of(const Paper& paper, const language::Relation& printed,
                          const mechanics::Derivation& derivation, const language::Symbols& symbols,
                          const std::vector<language::Relation>& conditions);

}  // namespace rederive::paper
