// Lessons on a paper that is a folder: lesson-01.md, lesson-02.md …
//
// A lesson begins with "# Title" and, if there are some, the lines "Teaches: …" and "Builds on: …". Each
// "## Heading" begins a step. Paragraphs, lists of lines that begin with "- ", tables with | and code between
// ``` are those of Markdown; `$…$` encloses mathematics in our own syntax. A directive has a line of its own:
//
//   {{argue 1}}      the derivation of row 1, step by step
//   {{result 5}}     the derived form of row 5
//   {{verdict 11}}   what is printed in row 11, and what the ledger found
//   {{ask period}}   an exercise of exercises.toml
//   {{table f x = 0:1:5, a = 2}}   values of the function f of functions.toml, here at five values of x
//   {{plot f x = 0:1, a = 2}}      its graph
#pragma once

#include <filesystem>
#include <functional>
#include <lessons/page/lesson.hpp>
#include <string>
#include <vector>

namespace rederive::papers {

/// A lesson, and the ids of the rows that it covers.
struct MarkdownLesson {
  page::Lesson lesson;
  std::vector<std::string> rows;
};

/// Returns what a page shows in the place of {{ask ID}}. Throws std::out_of_range for an unknown exercise.
using Ask = std::function<std::vector<page::Passage>(const std::string& id)>;

/// Returns the lesson in a file. `ask` is called when the page is written. Throws BadInput, with file and
/// line, for a directive that is not one of those above, for an unknown row or function, and for mathematics
/// that cannot be read.
MarkdownLesson read_lesson(const paper::Paper& paper, const std::filesystem::path& file, int number,
                           const Ask& ask);

/// Returns the files of the lessons in a folder, in order. Throws BadInput if their numbers leave a gap.
std::vector<std::filesystem::path> lesson_files(const std::filesystem::path& folder);

}  // namespace rederive::papers
