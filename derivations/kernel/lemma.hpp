// A proof as a lemma of Coq.
//
// The hypotheses are the ranges of the symbols, what is given and assumed, and the side conditions that the
// proof reports. The conclusion is that every divisor is not 0 and every root exists, and that the two
// statements say the same. The script names the phases (exponential_ring.hpp), writes each argument as a sum
// of them, expands by the addition theorems and leaves an identity of fractions to `ring` or `field`; squares
// of cosines and roots are facts. Nothing is searched by Coq, but signs of divisors.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/decide/proof.hpp>
#include <derivations/identity/polynomial.hpp>

namespace rederive {

/// What a lemma is about: left and right are the same, under what is given and assumed.
struct Question {
  Relation left, right;
  Symbols symbols;
  std::vector<Given> given = {};
  std::vector<Relation> assumptions = {};
};

/// "Lemma name : statement. Proof. … Qed." with the steps of the script, for what was proved. Throws
/// Undecidable, saying why, where there is no script for a proof of its kind.
std::string lemma(const std::string& name, const Question& question, const Proof& proof);

/// Whether the script of a question ends: two expressions are the same in the ring, two relations differ by a
/// factor that has a sign. Then `lemma` may be asked with an empty proof.
bool has_script(const Question& question);

/// The same for what was refuted: there is a point in the ranges at which both have values, one holds and the
/// other one does not.
std::string refutation(const std::string& name, const Question& question, const Proof& proof);

}  // namespace rederive
