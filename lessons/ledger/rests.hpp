// What each row rests on: which rows of the ledger follow from theorems alone, and what is assumed.
#pragma once

#include <derivations/kernel/scripts.hpp>

namespace rederive::ledger {

/// The way in which Coq obtains a row.
struct Support {
  enum class By {
    name,        ///< it is not a row but an assumption of theorems: Newton, the linearisation
    hypothesis,  ///< it is assumed: a definition, or a row that follows from no other row
    theorem,     ///< by theorems in the files of the project
    step,        ///< by algebra from the rows before it; see steps.hpp
    nothing      ///< by computer algebra alone
  };
  std::string id;
  By by;
  std::vector<std::string> lemmas;  ///< their names
  std::vector<std::string> from;    ///< the hypotheses of its theorems: rows and names
  bool is_corrected;                ///< it is refuted as printed, and the theorem states the correct form
  bool is_whole = false;  ///< it and all rows before it, down to hypotheses, follow by theorems or steps
};

/// Returns one support for each row, in the order of the ledger, and then the names. `lemmas` are all lemmas
/// of the paper. Throws std::out_of_range for a name that the paper does not list among its assumptions.
std::vector<Support> supports_of(const paper::Paper& paper, const std::vector<paper::Entry>& entries,
                                 const std::vector<kernel::Lemma>& lemmas);

/// Returns how many rows are whole.
int whole(const std::vector<Support>& supports);
/// Returns "150 of 221 rows rest wholly on theorems; 24 are assumed".
std::string summary(const std::vector<Support>& supports);

/// Returns a page in Markdown: the counts, what is assumed, what each row rests on, and the rows without a
/// lemma. It shows rests.svg.
std::string rests_page(const std::vector<paper::Entry>& entries, const std::vector<Support>& supports);
/// Returns a drawing in SVG in which each row is to the right of all rows that it follows from.
std::string rests_drawing(const std::vector<Support>& supports);

}  // namespace rederive::ledger
