// What a paper prints, as equations.toml says it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace rederive::paper {

/// One row of equations.toml: what is printed, and what we expect to find. No answer is stored.
struct Row {
  std::string id, section, kind, printed, latex, domain;
  std::string
      statement;  ///< a result of ours, in the form in which we state it; the paper prints nothing like it
  /// What is compared with the derivation: what is printed, or what we state.
  const std::string& claim() const { return kind == "result" ? statement : printed; }
  std::vector<std::string> follows_from;
  std::vector<std::string> rests_on_it;  ///< ids of the rows that follow from it, directly or through others
  std::string expected;                  ///< a verdict
  std::string error;                     ///< with refuted: sign, factor, argument …; rows.cpp lists them
  std::string consequence;               ///< with refuted: what rests on it, and whether that is still right
  std::string note;                      ///< anything a reader should know
  std::string scan_repaired;             ///< what scanning damaged and how it was restored; empty if nothing
};

/// Reads equations.toml. Throws BadInput naming file, line, row and what would be right.
std::vector<Row> read_rows(const std::filesystem::path& file);

}  // namespace rederive::paper
