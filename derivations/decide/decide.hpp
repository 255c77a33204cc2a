// Decides whether two expressions, equations or inequalities are the same.
//
// An identity is proved where both sides are defined; if one side is defined where the other is not, that is
// a side condition, and it is listed. Relations are the same if, wherever both have values, one holds where
// and only where the other one does. In this order:
//
// 1. what equations say of a symbol is put in (problem.hpp);
// 2. both statements become fractions of the ring of exponentials, with what must hold for them to have
// values
//    (comparison.hpp);
// 3. the difference is 0, or the two differ by a factor without zero or pole, positive for inequalities:
// proved by
//    identity (compare.hpp);
// 4. points at which the two differ beyond doubt, in ball arithmetic: refuted (points.hpp);
// 5. each follows from the other one by a certificate of signs: proved by sign
// (derivations/sign/certificate.hpp);
// 6. series in small symbols (expansion.hpp).
//
// What none of these decides is undecided. Nothing is ever proved by agreement at points; but nothing is
// called proved either before points were tried and agreed.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/decide/proof.hpp>

namespace rederive {

/// Decides left against right: two expressions, two equations or two inequalities. A chain says that all its
/// links hold: K = a = b that K = a and K = b. Against a relation of numbers, 0 < 1, the other one is asked
/// wherever it has a value. What is given is put in first; assumptions are sign conditions and equations that
/// hold. The verdict is proved, proved_under where equations that are assumed are needed, refuted or
/// undecided. Throws std::bad_alloc alone.
Proof decide(const Relation& left, const Relation& right, const Symbols& symbols,
             const std::vector<Given>& given = {}, const std::vector<Relation>& assumptions = {});

/// What an exception comes to, said to a reader: our own words stay; a pole, an overflow and the rest get a
/// sentence each, for GiNaC and CLN speak of their own insides. std::bad_alloc is thrown on.
std::string in_plain_words(const std::exception& error);

/// Whether the assumptions contradict each other, or the ranges: then nothing follows from them.
bool contradict(const std::vector<Relation>& assumptions, const Symbols& symbols);

}  // namespace rederive
