// Writes a proof as a lemma of Coq.
//
// The hypotheses are the ranges of the symbols, what is given and assumed, and the side conditions of the
// proof. The conclusion is that no divisor is 0, that every root exists, and that the two statements are
// equivalent. The script names the phases (exponential_ring.hpp), writes each argument as a sum of phases,
// expands by the addition theorems and leaves an identity of fractions to `ring` or `field`. Squares of
// cosines and roots are facts. Coq searches for nothing but signs of divisors.
#pragma once

#include <derivations/decide/problem.hpp>
#include <derivations/decide/proof.hpp>
#include <derivations/identity/polynomial.hpp>

namespace rederive::kernel {

/// The statement of a lemma: left and right are the same, under what is given and assumed.
struct Question {
  language::Relation left, right;
  language::Symbols symbols;
  std::vector<language::Given> given = {};
  std::vector<language::Relation> assumptions = {};
};

/// Returns "Lemma name : statement. Proof. … Qed." for a question that was proved. Throws Undecidable, with
/// the reason, if there is no script for this kind of proof.
std::string lemma(const std::string& name, const Question& question, const decide::Proof& proof);

/// Returns whether the script of a question succeeds, that is, two expressions are the same in the ring, or
/// two relations differ by a factor that has a sign. Then `lemma` also accepts an empty proof.
bool has_script(const Question& question);

/// Returns the lemma of a question that was refuted: at some point in the ranges both statements have values,
/// and one holds and the other does not. Throws as `lemma` does.
std::string refutation(const std::string& name, const Question& question, const decide::Proof& proof);

}  // namespace rederive::kernel
