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
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace rederive {

/// Theorems of Coq about a paper, in files that ship with the project.
struct Theorems {
  struct File {
    std::string name;      ///< "Thresholds.v"
    std::string row = {};  ///< the row that its theorems are about whose names do not say one
  };
  std::vector<std::string> prelude = {};  ///< files that they need beside those of the kernel
  std::vector<File> files = {};           ///< in the order in which they compile
  /// What theorems assume beside rows of the ledger: a name, and what it says.
  std::map<std::string, std::string> assumptions = {};
};

struct Paper {
  std::string title = {};
  std::filesystem::path equations = {};   ///< the file with what it prints; see equations_file
  Once<std::vector<Row>> rows = {};       ///< see rows_of
  Symbols symbols = {};                   ///< the ends of all ranges are numbers
  std::vector<Relation> conditions = {};  ///< what the declared ranges say beside numbers: theta_0 < alpha
  Derivations derivations = {};
  /// Symbols that `prove` takes for any real number, because everybody uses them for other things.
  std::vector<std::string> free_letters = {};
  /// Symbols that a typesetter may take for each other; mutate.hpp puts the second in the place of the first.
  std::map<std::string, std::string> look_alikes = {};
  /// Whether names of symbols are mathematics in the words of its steps and rows, without $…$ around them.
  bool has_names_in_words = false;
  Theorems theorems = {};
  Emission (*emission)() = nullptr;  ///< its numeric functions; nullptr: none
  /// The file that makes this value, by `Paper{…}` with braces; its rows are looked for beside it.
  const char* source = __builtin_FILE();  // Clang 14 has no std::source_location

  /// Declares symbols, or declares them anew. A range may have other symbols at its ends, such as
  /// "(0, alpha)": what it says of them goes to `conditions`. Throws std::invalid_argument, naming the
  /// symbol, for a unit or a range that cannot be read, a range that is empty, and two symbols that are
  /// written alike.
  void declare(const std::vector<Symbol>& all);
};

/// The file with the rows of a paper. A relative name is looked for beside the source that makes the paper,
/// beside the program, in the folder above that, and where the program runs. Throws BadInput if there is
/// none.
std::filesystem::path equations_file(const Paper& paper);
/// Its rows, read when they are first asked for. Throws BadInput naming file, line, row and what would be
/// right.
const std::vector<Row>& rows_of(const Paper& paper);
/// One of them. Throws std::out_of_range naming the id if there is none.
const Row& row_of(const Paper& paper, const std::string& id);

/// The derivation of a row, with the results that its steps cite; std::nullopt if none is listed. Throws
/// std::logic_error if it is derived from itself or cites a row without derivation, and what it throws
/// itself.
std::optional<Derivation> derivation_of(const Paper& paper, const std::string& id);
/// The same with the results that the steps of `derivation` cite. Throws as well.
Derivation with_citations(const Paper& paper, Derivation derivation);

}  // namespace rederive
