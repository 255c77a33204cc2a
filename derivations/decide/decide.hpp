// Decides whether two statements are the same. README.md has the order of the decision.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/decide/proof.hpp>

namespace rederive {

/// Decides left against right: two expressions, two equations or two inequalities. A chain says that all its
/// links hold. To ask whether a statement holds wherever it has a value, compare it with 0 < 1. What is given
/// is substituted first; assumptions are sign conditions and equations that hold. The verdict is proved,
/// proved_under where equations that are assumed are needed, refuted or undecided. Throws std::bad_alloc
/// alone.
Proof decide(const Relation& left, const Relation& right, const Symbols& symbols,
             const std::vector<Given>& given = {}, const std::vector<Relation>& assumptions = {});

/// An exception as a sentence for the user: our own messages are kept; a pole, an overflow and the rest of
/// GiNaC and CLN get a sentence each. To be called in a handler: std::bad_alloc is thrown on.
std::string in_plain_words(const std::exception& error);

/// Whether the assumptions contradict each other, or the ranges: then nothing follows from them.
bool contradict(const std::vector<Relation>& assumptions, const Symbols& symbols);

/// Compares the series of two expressions up to `order` in the small symbols, all of one size: Taylor
/// polynomials, and at a pole negative powers before them. Of two equations, the series of what they say of a
/// symbol that is not small, for which both are linear: one that stands alone on a side, if there is one. The
/// verdict is approximation, refuted or undecided. By the side conditions no divisor's lowest term is 0.
Proof decide_to_order(const Relation& left, const Relation& right, const std::vector<std::string>& small,
                      int order, const Symbols& symbols, const std::vector<Given>& given = {},
                      const std::vector<Relation>& assumptions = {});

}  // namespace rederive
