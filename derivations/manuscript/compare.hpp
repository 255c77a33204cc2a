// Compares what a manuscript writes on two sides.
#pragma once

#include <derivations/decide/proof.hpp>
#include <derivations/manuscript/stated.hpp>
#include <derivations/manuscript/values.hpp>

namespace rederive::manuscript {

/// What a comparison finds.
struct Compared {
  enum class Is { proved, refuted, undecided } is = Is::undecided;
  std::vector<std::string> conditions = {};
  std::string witness = {}, reason = {};
  std::string repair = {};
  bool is_numbers = false;     ///< both sides are constants
  bool is_taken_back = false;  ///< it was refuted, but that may rest on something that the text leaves unsaid
  bool is_loss = false;        ///< the line before follows from this one, but has more solutions
};

/// Compares two sides by a relation, wherever both have values. Names that the text does not bound are real;
/// a refutation must also hold where they are positive, since texts leave that unsaid.
Compared compare(const language::Tree& left, const std::string& relation, const language::Tree& right,
                 const Meanings& meanings, const StatedSymbols& stated);

/// Returns whether an equation follows from others, and whether they follow from it.
Compared compare_step(const language::Relation& equation, const std::vector<language::Relation>& before,
                      bool is_equivalence, const Meanings& meanings, const StatedSymbols& stated);

/// Returns the right side with one part changed so that it equals the left side; "" if there is none.
std::string repair_of(const language::Tree& left, const language::Tree& right, const Meanings& meanings,
                      const StatedSymbols& stated);
/// The same of an equation that should follow from another one.
std::string repair_of(const language::Relation& right, const language::Relation& wrong,
                      const Meanings& meanings, const StatedSymbols& stated);

/// Returns the number of digits behind the point of a number as it is written, perhaps negative; nothing for
/// others.
std::optional<int> decimals_of(const language::Tree& tree);

}  // namespace rederive::manuscript
