// What a question of `ledger prove` needs: which givens, and whether a proof is worth the attempt.
#pragma once

#include <derivations/algebra/prove.hpp>
#include <vector>

namespace rederive {

/// The givens that the two statements mention, directly or through one of these, and those that may keep a
/// point out: b = R*sin(alpha) with b > 0 says something of R and alpha, p = sqrt(3*g/(4*R)) does not where g
/// and R are positive. Each is needed or keeps points out; without the others nothing changes.
std::vector<Given> relevant(const std::vector<Given>& given, const Relation& left, const Relation& right,
                            const Symbols& symbols);

/// Whether the algebra alone proves it: no points are looked at but for a few at which the two may differ,
/// and nothing is refuted. True is a proof; false is not to say that prove() finds none.
bool goes_through(const Relation& left, const Relation& right, const Symbols& symbols,
                  const std::vector<Given>& given);

}  // namespace rederive
