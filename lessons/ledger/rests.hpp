// What rests on what: which rows of the ledger are theorems all the way down, and what is assumed.
#pragma once

#include <derivations/kernel/scripts.hpp>

namespace rederive {

/// How Coq has a row.
struct Support {
  enum class By {
    name,        ///< no row, but what theorems call an assumption: Newton, the linearisation
    hypothesis,  ///< a definition, or a row that follows from nothing before it: assumed
    theorem,     ///< by theorems of the files that ship
    step,        ///< by algebra from the rows before it (steps.hpp)
    nothing      ///< derived by computer algebra alone
  };
  std::string id;
  By by;
  std::vector<std::string> lemmas;  ///< names
  std::vector<std::string> from;    ///< what its theorems take as hypotheses: rows and names
  bool is_corrected;                ///< refuted as printed: the theorem says what is right
  bool is_whole = false;  ///< by a theorem or a step, and so are the rows before it, down to hypotheses
};

/// One for each row, in the order of the ledger, and then the names. `lemmas` are all of them. Throws
/// std::out_of_range for a name that is none.
std::vector<Support> supports_of(const Paper& paper, const std::vector<Entry>& entries,
                                 const std::vector<Lemma>& lemmas);

/// How many rows are theorems all the way down.
int whole(const std::vector<Support>& supports);
/// "150 of 221 rows rest wholly on theorems; 24 are assumed".
std::string summary(const std::vector<Support>& supports);

/// A page in Markdown: the counts, what is assumed, what each row rests on, and what no lemma reaches.
/// rests.svg draws it.
std::string rests_page(const std::vector<Entry>& entries, const std::vector<Support>& supports);
/// A drawing in SVG: each row stands to the right of all the rows that it follows from.
std::string rests_drawing(const std::vector<Support>& supports);

}  // namespace rederive
