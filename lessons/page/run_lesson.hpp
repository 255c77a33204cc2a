// The one main that all lessons share.
#pragma once

#include <lessons/page/lesson.hpp>

namespace rederive {

/// Parses the flags that all lessons share, and prints what they ask for of a lesson on `paper`. Returns the
/// exit code.
int run_lesson(const Paper& paper, const Lesson& lesson, int argc, char** argv);
/// The programs of all lessons, in order: they stand beside the one that runs.
std::vector<std::string> all_lessons();

}  // namespace rederive
