// The `main` of all lessons.
#pragma once

#include <filesystem>
#include <lessons/page/lesson.hpp>
#include <map>

namespace rederive::page {

/// Parses the flags of a lesson about `paper` and writes what they ask for. `series` returns the lessons to
/// which it belongs, and is called when they are needed. Returns the exit code.
int run_lesson(const paper::Paper& paper, const Lesson& lesson, const std::function<LessonSeries()>& series,
               int argc, char** argv);
/// Returns the lessons of the built-in paper: their programs and what equations_of_lessons.toml lists.
LessonSeries built_in_series(const paper::Paper& paper);
/// Returns a lesson as a web page. `forms` is a file that forms_json (exercises) has written; if it is empty,
/// the page says how to answer.
std::string lesson_page(const paper::Paper& paper, const Lesson& lesson, const LessonSeries& series,
                        const std::filesystem::path& forms);
/// Returns a lesson in Markdown.
std::string lesson_in_markdown(const paper::Paper& paper, const Lesson& lesson, const LessonSeries& series);
/// Returns the names of the programs of all lessons, in order. They are in the folder of the program that
/// runs.
std::vector<std::string> all_lessons();
/// Returns the titles of the lessons by their programs, as the programs print them: "Lesson 1. The block and
/// its motion". Throws std::runtime_error if a program fails.
std::map<std::string, std::string> titles_of_lessons();

}  // namespace rederive::page
