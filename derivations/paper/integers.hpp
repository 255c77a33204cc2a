// Symbols that are whole numbers, in a comparison.
#pragma once

#include <derivations/decide/decide.hpp>
#include <functional>
#include <string>
#include <vector>

namespace rederive::paper {

/// What is compared, in terms of symbols.
struct Compared {
  language::Relation printed, derived;
  std::vector<language::Given> given;
  std::vector<language::Relation> conditions;
};

/// Returns what `compare` finds, if the symbols in `integers` are whole numbers. Where one is in the exponent
/// of a negative number, or times pi in a sine, a cosine or a tangent, each remainder is compared by itself:
/// (-1)^n is 1 for even n. A refutation needs a witness at which they are whole; without one, the verdict is
/// undecided.
decide::Proof compare_whole(const Compared& both, const std::vector<std::string>& integers,
                            const language::Symbols& symbols,
                            const std::function<decide::Proof(const Compared&)>& compare);

}  // namespace rederive::paper
