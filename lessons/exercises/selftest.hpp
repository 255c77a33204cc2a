// Proves that the exercise set is sound.
#pragma once

#include <lessons/exercises/classroom.hpp>

namespace rederive::classroom {

/// Checks all exercises, and their variants of 20 seeds: each stub fails, each right answer passes, each slip
/// gets its note, and no hint gives the answer away. Writes the complaints and returns the exit code.
int selftest(const Classroom& room);

}  // namespace rederive::classroom
