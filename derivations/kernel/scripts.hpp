// Writes the ledger as a folder of Coq scripts.
#pragma once

#include <algorithm>
#include <array>
#include <derivations/paper/ledger.hpp>
#include <filesystem>

namespace rederive {

/// A lemma with its proof and the comment before it.
struct Lemma {
  std::string id, file, name;  ///< "71", "Ledger.v", "equation_71"
  std::string kind;            ///< row, refutation, derivation, instance, threshold, claim
  std::string text = {};       ///< empty if there is no script, and for a theorem whose file ships
  std::string why = {};        ///< then: why
};

/// Returns "equation_17b"; characters of an id other than letters and digits become underscores.
std::string lemma_name(const std::string& kind, std::string id);

/// The lemma of a row: proved, or refuted by its witness. None of a definition.
std::optional<Lemma> lemma_of(const Entry& entry);

/// The prelude and what theorems need beside it, and their files, in the order in which they compile.
inline constexpr std::array prelude{"Rederive.v", "Intervals.v", "Bounds.v", "Solutions.v", "Limits.v"};
inline constexpr std::array theorem_files{"Initiation.v",    "Derivations.v", "Impact.v",   "Responses.v",
                                          "Critical.v",      "Instances.v",   "Claims.v",   "Thresholds.v",
                                          "ImpactInPulse.v", "AfterImpact.v", "OneImpact.v"};
/// Whether a lemma is one of theirs.
inline bool ships(const Lemma& lemma) { return std::ranges::count(theorem_files, lemma.file) > 0; }
/// Returns whether there is no script for it; then `why` gives the reason.
inline bool is_skipped(const Lemma& lemma) { return lemma.text.empty() && !ships(lemma); }
/// Their theorems, read off the files; derivation_8_18 is about the rows 8 and 18.
std::vector<Lemma> shipped_theorems();
/// Such a theorem with its proof, and the comment before it.
std::string text_of(const Lemma& theorem);

/// The first line of every file of lemmas.
inline constexpr const char* imports = "From Rederive Require Import Rederive Bounds.\n";

/// The text of a file that ships with this room. Throws std::runtime_error.
std::string shipped(const std::string& name);

/// The files by their names: what ships, those of the lemmas, _CoqProject and a Makefile.
std::map<std::string, std::string> files_of(const std::vector<Lemma>& lemmas);
/// Writes them, and `more` files by their names, into a folder: all of them or none. Throws BadInput where
/// that is not possible.
void write_scripts(const std::filesystem::path& folder, const std::vector<Lemma>& lemmas,
                   const std::map<std::string, std::string>& more = {});

}  // namespace rederive
