// Judges the steps of a manuscript: which line does not follow, and at which values one sees it.
#pragma once

#include <derivations/decide/proof.hpp>
#include <derivations/manuscript/stated.hpp>

namespace rederive::manuscript {

/// What is found about a step.
enum class Finding { proved, wrong, undecided, not_read, assumed };
std::string to_string(Finding finding);  ///< "not_read"

/// A step: one relation between two sides, or an equation that follows from the one before.
struct Link {
  Place place;
  std::string left, relation, right;  ///< as they are written
  Finding finding = Finding::assumed;
  std::vector<std::string> conditions = {};  ///< under which it holds, in our syntax
  std::string witness = {};                  ///< "at x = 1/2 the left side is 3, the right side 5"
  std::string repair = {};                   ///< the right side as it would be right
  std::string reason = {};                   ///< why it is not read or undecided
  bool is_loss = false;                      ///< it is wrong because a solution of the line before is lost
};

struct JudgedDisplay {
  Place place;
  std::string source;
  std::vector<Link> links = {};
};

struct Report {
  std::string file;
  std::vector<JudgedDisplay> displays = {};
  StatedSymbols symbols = {};

  std::size_t count(Finding finding) const;
};

/// Judges all displays, and the formulas in the text if `with_inline`. `symbols` are declared by the user.
/// Throws BadInput for a directive that cannot be read.
Report check(const Manuscript& manuscript, const StatedSymbols& symbols, bool with_inline);

}  // namespace rederive::manuscript
