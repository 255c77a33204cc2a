// Decides whether two statements are the same. README.md gives the order of the decision.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/decide/proof.hpp>

namespace rederive::decide {

/// Compares two expressions, two equations or two inequalities. A chain says that all its links hold. To ask
/// whether a statement holds wherever it has a value, compare it with 0 < 1. `given` is substituted first;
/// `assumptions` are sign conditions and equations that hold. The verdict is proved, proved_under (if assumed
/// equations are needed), refuted or undecided. Throws only std::bad_alloc.
Proof decide(const language::Relation& left, const language::Relation& right,
             const language::Symbols& symbols, const std::vector<language::Given>& given = {},
             const std::vector<language::Relation>& assumptions = {});

/// Returns an exception as a sentence for the user: our own messages as they are, and a sentence for a pole,
/// an overflow and other errors of GiNaC and CLN. Call it in a handler: it throws std::bad_alloc on.
std::string in_plain_words(const std::exception& error);

/// Returns whether the assumptions contradict each other or the ranges; then nothing follows from them.
bool contradict(const std::vector<language::Relation>& assumptions, const language::Symbols& symbols);

/// Compares the series of two expressions up to `order` in the small symbols, which all have the same size:
/// Taylor polynomials, with negative powers at a pole. For two equations, compares the series of their
/// solutions for a symbol that is not small and in which both are linear, preferably one that is alone on a
/// side. The verdict is approximation, refuted or undecided. Side conditions exclude zeros of the lowest
/// terms of divisors.
Proof decide_to_order(const language::Relation& left, const language::Relation& right,
                      const std::vector<std::string>& small, int order, const language::Symbols& symbols,
                      const std::vector<language::Given>& given = {},
                      const std::vector<language::Relation>& assumptions = {});

}  // namespace rederive::decide
