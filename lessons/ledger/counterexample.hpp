// What was typed, at places where all that is assumed holds: read again from the texts, and put to the
// evaluator alone. What the assumptions were taken to say has no part in it.
#pragma once

#include <derivations/algebra/evaluate.hpp>
#include <lessons/ledger/prove_command.hpp>

namespace rederive {

/// Whether the witness shows what it is for: all that is assumed holds there, as far as it names the
/// symbols, and of two statements one holds and the other does not, or two expressions have two values. Of
/// series only the assumptions are looked at. `symbols` has all names of the request.
bool is_confirmed(const Witness& witness, const ProveRequest& request, const Symbols& symbols);

/// A point inside the declared ranges, where all that is assumed holds, and the statements do not say the
/// same: no proof can be right then. Of symbols that an equation names it may be rounded. 200 points are
/// looked at in doubles, and up to 24 that doubles do not rule out exactly.
std::optional<Point> counterexample(const ProveRequest& request, const Symbols& symbols);

/// The proof as it is, unless it is refuted by a witness that is not confirmed, or proved in spite of a
/// counterexample: then undecided, and the reason says so.
Proof unless_contradicted(Proof proof, const ProveRequest& request);

}  // namespace rederive
