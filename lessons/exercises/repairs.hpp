// Compares a wrong answer with the right one term by term, and finds the one part that makes the answer right
// when it is changed.
#pragma once

#include <functional>
#include <lessons/exercises/exercise.hpp>
#include <lessons/exercises/sieve.hpp>
#include <lessons/exercises/slips.hpp>

namespace rederive::classroom {

/// A wrong answer with one part changed.
struct Repair {
  language::Relation relation;     ///< the answer after the change
  Slip slip;                       ///< that the change undoes
  language::Tree part;             ///< what was changed, as typed; nullptr if it is the whole answer
  language::Tree other = nullptr;  ///< what was exchanged with the part
  language::Tree term = nullptr;   ///< that contains the part, if the same part is in others, too
};

/// Tries every single change, the plainest first, and passes those that the sieve lets through to `accept`,
/// until it returns true. `forms` of the right answer provide terms and factors that may be missing. Returns
/// nothing for an answer of more than 150 parts.
std::optional<Repair> repaired(const language::Relation& answer, const std::vector<language::Relation>& forms,
                               const Sieve& sieve, const Exercise& exercise,
                               const std::function<bool(const Repair&)>& accept);

/// Returns what to say to the student: the part, and what is wrong with it.
std::string in_words(const Repair& repair);

}  // namespace rederive::classroom
