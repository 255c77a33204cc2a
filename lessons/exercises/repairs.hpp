// Compares a wrong answer with the right one term by term: which one part of it, changed in which way, makes
// it right.
#pragma once

#include <functional>
#include <lessons/exercises/sieve.hpp>

namespace rederive::classroom {

/// One part of a student's answer changed.
struct Repair {
  Relation relation;     ///< the answer after the change
  std::string note;      ///< the slip that it undoes
  Tree part;             ///< what was changed, as typed; nullptr where it is all of it
  Tree other = nullptr;  ///< exchanged with the part
  Tree term = nullptr;   ///< in which it is, where the same part is in others, too
};

/// Tries every single change, the plainest first, and hands those to `accept` that pass the sieve, until it
/// takes one. `forms` of the right answer lend their terms and factors for what is missing. Gives up on an
/// answer of more than 150 parts.
std::optional<Repair> repaired(const Relation& answer, const std::vector<Relation>& forms, const Sieve& sieve,
                               const Exercise& exercise, const std::function<bool(const Repair&)>& accept);

/// What to say to the student: the part, and what is wrong with it.
std::string in_words(const Repair& repair);

/// The number as a small fraction, or as one of π; nothing where it is neither.
std::optional<Tree> plain_number(double value);

}  // namespace rederive::classroom
