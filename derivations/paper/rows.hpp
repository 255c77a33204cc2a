// What a paper prints, as equations.toml says it.
#pragma once

#include <derivations/decide/proof.hpp>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace rederive::paper {

/// A `result` is stated by us; the paper prints the others.
enum class RowKind { equation, inequality, definition, result };
/// Returns "equation", "inequality" …
std::string to_string(RowKind kind);

/// The kind of error in a refuted row.
// clang-format off
enum class RowError {
  sign, factor, argument, subscript, swapped_symbols, symbol, missing_term, extra_term, missing_factor,
  extra_factor, exponent, reciprocal, function, relation, limit, domain, dimension, constant, missing_dot
};
// clang-format on
/// Returns "sign", "sign and factor" …; "" if there is none.
std::string in_words(const std::vector<RowError>& errors);

/// One of the statements of a row that says several: a sign of ±, or an entry of a vector or a matrix.
struct RowPart {
  std::string name;     ///< "+", "2", "1,2"; its derivation is that of the row `ID[NAME]`
  std::string printed;  ///< in the grammar of language
};

/// One row of equations.toml: what is printed, and what we expect to find. No answer is stored.
struct Row {
  std::string id, section, printed, latex, domain;
  RowKind kind = RowKind::equation;
  std::string
      statement;  ///< a result of ours, in the form in which we state it; the paper prints nothing like it
  /// Returns what is compared with the derivation: what is printed, or what we state.
  const std::string& claim() const { return kind == RowKind::result ? statement : printed; }
  std::vector<std::string> assume;  ///< relations under which the row is compared: "theta_0 < alpha"
  int order = 0;                    ///< > 0: what is printed is an approximation to this order …
  std::string small;                ///< … in these symbols ("alpha, theta")
  std::vector<std::string> follows_from;
  std::vector<std::string> rests_on_it;  ///< ids of the rows that follow from it, directly or through others
  decide::Verdict expected = decide::Verdict::undecided;
  std::vector<RowError> errors;  ///< with refuted
  std::string consequence;       ///< with refuted: what rests on it, and whether that is still right
  std::string note;              ///< anything a reader should know
  std::string scan_repaired;     ///< what scanning damaged and how it was restored; empty if nothing
  std::map<std::string, std::string> places;  ///< key → "FILE:LINE"; "" is the row itself
  /// Returns "FILE:LINE" of a key, or of the row.
  std::string place_of(const std::string& key) const {
    const auto place = places.find(places.contains(key) ? key : "");
    return place == places.end() ? "" : place->second;
  }

  // What printed.hpp reads from it.
  std::string typed;            ///< what the file says, if it is not what `claim` says
  std::string read_as;          ///< how the LaTeX was read; empty without
  std::vector<RowPart> parts;   ///< empty if the row is one statement
  bool is_approximate = false;  ///< printed with ≈
  std::string fault;            ///< why it cannot be read; empty if it can
};

/// Reads equations.toml. Throws BadInput naming file, line, row and what would be right.
std::vector<Row> read_rows(const std::filesystem::path& file);

}  // namespace rederive::paper
