// The ledger as a folder of Coq scripts.
#pragma once

#include <derivations/paper/ledger.hpp>
#include <filesystem>

namespace rederive {

/// A lemma with its proof, and the comment that stands before it.
struct Lemma {
  std::string id, file, name;  ///< "71", "Ledger.v", "equation_71"
  std::string kind;            ///< row, refutation, derivation, threshold, claim
  std::string text;            ///< empty where there is no script, and of a theorem whose file ships
  std::string why;             ///< then: why
};

/// The lemma of a row: proved, or refuted by its witness. None of a definition.
std::optional<Lemma> lemma_of(const Entry& entry);

/// The theorems of the files that ship: Derivations.v, the equation of motion and the restitution from
/// positions; Thresholds.v, the response (57) and its threshold (71).
std::vector<Lemma> shipped_theorems();
/// Whether a lemma is one of these.
inline bool ships(const Lemma& lemma) {
  return lemma.file == "Derivations.v" || lemma.file == "Thresholds.v";
}

/// The first line of every file of lemmas.
inline constexpr const char* imports = "From Rederive Require Import Rederive Bounds.\n";

/// The text of a file that ships with this room: Rederive.v, the prelude; Bounds.v, interval arithmetic.
/// Throws std::runtime_error.
std::string shipped(const std::string& name);

/// The files by their names: what ships, those of the lemmas, _CoqProject and a Makefile.
std::map<std::string, std::string> files_of(const std::vector<Lemma>& lemmas);
/// Writes them into a folder, each file whole or not at all. Throws BadInput where that is not possible.
void write_scripts(const std::filesystem::path& folder, const std::vector<Lemma>& lemmas);

}  // namespace rederive
