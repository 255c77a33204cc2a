// Writes the ledger as a folder of Coq scripts.
#pragma once

#include <array>
#include <derivations/paper/ledger.hpp>
#include <filesystem>

namespace rederive::kernel {

/// A lemma with its proof and the comment before it.
struct Lemma {
  enum class Kind { row, refutation, derivation, instance, threshold, claim };
  std::string id, file, name;  ///< "71", "Ledger.v", "equation_71"
  Kind kind = Kind::row;
  std::string text = {};                  ///< empty if there is no script, and for a theorem whose file ships
  std::string why = {};                   ///< then: why
  bool ships = false;                     ///< whether its file ships with the project
  std::vector<std::string> derives = {};  ///< the rows that it derives from others
  std::vector<std::string> from = {};     ///< the premises of a theorem: rows, and names of assumptions
};

/// Returns "row", "refutation" …
std::string to_string(Lemma::Kind kind);

/// Returns "equation_17b"; characters of an id other than letters and digits become underscores.
std::string lemma_name(const std::string& kind, std::string id);

/// Returns the lemma of a row, which is proved or refuted by its witness; std::nullopt for a definition.
std::optional<Lemma> lemma_of(const paper::Paper& paper, const paper::Entry& entry);
/// Returns whether there is no script for a lemma; then `why` gives the reason.
inline bool is_skipped(const Lemma& lemma) { return lemma.text.empty() && !lemma.ships; }

/// The theorems about a paper that are written by hand.
struct Theorems {
  std::vector<std::string> prelude = {};  ///< the files that they need beside the prelude of all lemmas
  std::vector<std::string> files = {};    ///< in the order in which they compile
  std::vector<std::string> functions_of_time = {};      ///< the symbols that are functions in the theorems
  std::map<std::string, std::string> assumptions = {};  ///< premises that are not rows: name → sentence
  std::vector<Lemma> lemmas = {};
};

/// Reads the list of the theorems about a paper. Throws BadInput, with file and line, for a list that cannot
/// be read.
Theorems theorems_of(const paper::Paper& paper);
/// Returns the text of a file of theorems, with the rows in their statements (row_text.hpp) and the premises
/// of each theorem in a comment before it. Throws std::runtime_error.
std::string theorem_file(const paper::Paper& paper, const std::string& file);
/// Returns such a theorem with its proof, its premises and the comment before it. Throws std::runtime_error
/// if its file does not contain it.
std::string text_of(const paper::Paper& paper, const Lemma& theorem);

/// The files that all lemmas need, in the order in which they compile.
inline constexpr std::array prelude{"Rederive.v", "Intervals.v", "Bounds.v"};
/// The first line of every file of lemmas.
inline constexpr const char* imports = "From Rederive Require Import Rederive Bounds.\n";

/// Returns the text of a file that ships with this folder. Throws std::runtime_error if it is missing.
std::string shipped(const std::string& name);

/// Returns the files by their names: what ships, those of the lemmas, _CoqProject and a Makefile.
std::map<std::string, std::string> files_of(const paper::Paper& paper, const std::vector<Lemma>& lemmas);
/// Writes these files, and `more` files by their names, into a folder: all of them or none. Throws BadInput
/// if that is not possible.
void write_scripts(const paper::Paper& paper, const std::filesystem::path& folder,
                   const std::vector<Lemma>& lemmas, const std::map<std::string, std::string>& more = {});

}  // namespace rederive::kernel
