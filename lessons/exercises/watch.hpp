// Judges the files of a folder again whenever they change.
#pragma once

#include <lessons/exercises/classroom.hpp>

namespace rederive::classroom {

/// Watches DIR/<exercise id>.txt until the student quits; `once`: looks once. Returns the exit code.
int watch(const Classroom& room, const std::string& folder, bool once);

}  // namespace rederive::classroom
