// Writes the ledger as a folder of Coq scripts.
#pragma once

#include <derivations/paper/ledger.hpp>
#include <filesystem>

namespace rederive {

/// A lemma with its proof and the comment before it.
struct Lemma {
  std::string id, file, name;  ///< "71", "Ledger.v", "equation_71"
  std::string kind;            ///< row, refutation, derivation, instance, threshold, claim
  std::string text = {};       ///< empty if there is no script, and for a theorem whose file ships
  std::string why = {};        ///< then: why
  bool ships = false;          ///< whether its file ships with the project
};

/// Returns "equation_17b"; characters of an id other than letters and digits become underscores.
std::string lemma_name(const std::string& kind, std::string id);

/// The lemma of a row: proved, or refuted by its witness. None of a definition.
std::optional<Lemma> lemma_of(const Paper& paper, const Entry& entry);

/// The files that all lemmas need, and then those that the theorems about a paper need, in the order in which
/// they compile.
std::vector<std::string> prelude_of(const Paper& paper);
/// Returns whether there is no script for it; then `why` gives the reason.
inline bool is_skipped(const Lemma& lemma) { return lemma.text.empty() && !lemma.ships; }
/// The theorems about a paper, read off its files; derivation_8_18 is about the rows 8 and 18.
std::vector<Lemma> shipped_theorems(const Paper& paper);
/// Such a theorem with its proof, and the comment before it.
std::string text_of(const Lemma& theorem);

/// The first line of every file of lemmas.
inline constexpr const char* imports = "From Rederive Require Import Rederive Bounds.\n";

/// The text of a file that ships with this room. Throws std::runtime_error.
std::string shipped(const std::string& name);

/// The files by their names: what ships, those of the lemmas, _CoqProject and a Makefile.
std::map<std::string, std::string> files_of(const Paper& paper, const std::vector<Lemma>& lemmas);
/// Writes them, and `more` files by their names, into a folder: all of them or none. Throws BadInput where
/// that is not possible.
void write_scripts(const Paper& paper, const std::filesystem::path& folder, const std::vector<Lemma>& lemmas,
                   const std::map<std::string, std::string>& more = {});

}  // namespace rederive
