// The program `exercises`, for any course.
#pragma once

#include <functional>
#include <lessons/exercises/course.hpp>
#include <string>

namespace rederive::classroom {

/// Runs the command line of the classroom. `course` returns the course and is called when it is needed;
/// `subject` says in the help what the exercises are about: "the rocking block". Returns the exit code.
int run_exercises(const std::function<const Course&()>& course, const std::string& subject, int argc,
                  char** argv);

}  // namespace rederive::classroom
