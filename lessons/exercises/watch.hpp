// Judges the files of a folder again whenever they change.
#pragma once

#include <lessons/exercises/classroom.hpp>

namespace rederive::classroom {

/// Judges DIR/ID.txt again whenever it changes, for the id of each exercise, until the student quits; `once`:
/// looks once. Returns the exit code.
int watch(const Classroom& room, const std::string& folder, bool once);

}  // namespace rederive::classroom
