// The `main` of all lessons.
#pragma once

#include <lessons/page/lesson.hpp>
#include <map>

namespace rederive::page {

/// Parses the flags of a lesson about `paper` and writes what they ask for. Returns the exit code.
int run_lesson(const paper::Paper& paper, const Lesson& lesson, int argc, char** argv);
/// Returns the names of the programs of all lessons, in order. They are in the folder of the program that
/// runs.
std::vector<std::string> all_lessons();
/// Returns the titles of the lessons by their programs, as the programs print them: "Lesson 1. The block and
/// its motion". Throws std::runtime_error if a program fails.
std::map<std::string, std::string> titles_of_lessons();

}  // namespace rederive::page
