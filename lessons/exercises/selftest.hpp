// Proves that the exercise set is sound.
#pragma once

#include <lessons/exercises/classroom.hpp>

namespace rederive::classroom {

/// What was found in the exercises.
struct Report {
  std::size_t variants = 0, checks = 0;
  std::vector<std::string> complaints = {};  ///< each with file, line and exercise
};

/// Checks all exercises, and their variants of 20 seeds: each stub fails, each right answer passes, each slip
/// gets its note, what is said to it is true of it, nothing that is said gives the answer away, and no two
/// examples are alike; and, if it is told so, that no lesson has the answer before it asks. Throws BadInput
/// for an exercise that cannot be read.
Report tested(const Classroom& room, bool with_lessons = false);
/// Writes the complaints and returns the exit code.
int selftest(const Classroom& room, bool with_lessons = false);

}  // namespace rederive::classroom
