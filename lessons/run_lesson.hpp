// The one main that all lessons share.
#pragma once

#include <lessons/lesson.hpp>

namespace rederive {

/// Parses the flags that all lessons share, and prints what they ask for. Gives the exit code.
int run_lesson(const Lesson& lesson, int argc, char** argv);

}  // namespace rederive
