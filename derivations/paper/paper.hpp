// A paper as a value: what it declares, what it prints, what is derived, and what is made of that.
#pragma once

#include <derivations/emit/emit.hpp>
#include <derivations/language/print.hpp>
#include <derivations/language/syntax.hpp>
#include <derivations/mechanics/dimension.hpp>
#include <derivations/paper/derivations.hpp>
#include <derivations/paper/once.hpp>
#include <derivations/paper/rows.hpp>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rederive::paper {

/// A paper: its symbols, its printed rows and its derivations. A program may hold several papers.
struct Paper {
  std::string title = {};
  std::vector<std::string> authors = {};
  std::string year = {}, doi = {};
  std::filesystem::path folder = {};                ///< of its data files; empty if it has none of its own
  std::filesystem::path equations = {};             ///< the file with the printed rows; see equations_file
  Once<std::vector<Row>> rows = {};                 ///< see rows_of
  language::Symbols symbols = {};                   ///< the ends of all ranges are numbers
  std::vector<language::Relation> conditions = {};  ///< the ranges that compare symbols: theta_0 < alpha
  std::vector<std::string> integers = {};           ///< symbols that are whole numbers
  Derivations derivations = {};
  /// Symbols that `prove` reads as arbitrary real numbers, because users give them other meanings.
  std::vector<std::string> free_letters = {};
  /// Symbols that a typesetter may confuse: mutate.hpp replaces the first by the second.
  std::map<std::string, std::string> look_alikes = {};
  /// Whether sentences of its steps and rows write names of symbols as mathematics without $…$.
  bool has_names_in_words = false;
  /// The list of the Coq theorems about it, a file among the scripts that ship; empty if there are none.
  std::string theorems = {};
  std::function<emit::Emission()> emission = {};  ///< its numeric functions; empty if it has none
  /// The source file in which `Paper{…}` is written, with braces. A relative `equations` is searched beside
  /// it.
  const char* source = __builtin_FILE();  // Clang 14 has no std::source_location

  /// Declares the symbols in `all`; a name that is declared already is declared anew. If a range has another
  /// symbol at an end, as in "(0, alpha)", the comparison with that symbol is added to `conditions`. Throws
  /// std::invalid_argument, with the name of the symbol, for a unit or a range that cannot be read, for an
  /// empty range, and for two symbols that are written alike.
  void declare(const std::vector<language::Symbol>& all);
};

/// Returns the path of the file with the rows of a paper. A relative path is searched beside the source file
/// of the paper, beside the program, in the folder above the program, and in the current folder, in this
/// order. Throws BadInput, with the places searched, if no such file exists.
std::filesystem::path equations_file(const Paper& paper);
/// Returns the rows of a paper; the first call reads them. Throws BadInput, with file, line and row, for a
/// file that cannot be read.
const std::vector<Row>& rows_of(const Paper& paper);
/// Returns the rows in another file, with their printed forms read by `read_printed`. Throws as rows_of does.
std::vector<Row> rows_in(const Paper& paper, const std::filesystem::path& file);
/// Returns the id of the row to which a derivation belongs: "7" for "7[1,2]", "7[+]" and "7".
std::string row_id(const std::string& derivation);
/// Returns the row with the given id. Throws std::out_of_range, with the id, if the paper has no such row.
const Row& row_of(const Paper& paper, const std::string& id);

/// Returns the derivation of a row, in which each citation is replaced by the cited result, or std::nullopt
/// if the paper lists no derivation for the row. Throws std::logic_error if the row is derived from itself or
/// cites a row without derivation; exceptions of the derivation pass through.
std::optional<mechanics::Derivation> derivation_of(const Paper& paper, const std::string& id);
/// Returns `derivation` with each citation in its steps replaced by the cited result. Throws as
/// derivation_of.
mechanics::Derivation with_citations(const Paper& paper, mechanics::Derivation derivation);

}  // namespace rederive::paper
