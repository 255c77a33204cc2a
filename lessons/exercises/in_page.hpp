// Exercises as passages: for the pages of `exercises serve`, and for those that a teacher hands back. What
// students wrote is only ever text in them.
#pragma once

#include <lessons/exercises/classroom.hpp>
#include <lessons/page/passages.hpp>
#include <map>
#include <string>

namespace rederive::classroom {

/// Returns the beginning of a text, at most `most` bytes, in printable characters.
std::string cut(const std::string& text, std::size_t most);
/// Returns the same as a sentence that shows it as it is typed.
std::string as_code(const std::string& text, std::size_t most = 2000);
/// Returns the paragraphs of a text with marks as sentences. One with a formula that cannot be read is plain
/// text.
std::vector<std::string> sentences_of(const std::string& text, const language::Symbols& symbols);
/// Returns what the judge says of an answer.
page::Findings verdict_findings(const Opinion& opinion, const language::Symbols& symbols);

/// Returns the forms of all exercises, and the script that serves them, as the option --forms of a lesson
/// reads them.
std::string forms_json(const Classroom& room);
/// Returns the page of all exercises, lesson by lesson, with what is done. `titles` has the titles of the
/// lessons by their programs, in order.
std::string page_of_exercises(const Classroom& room, const std::map<std::string, std::string>& titles);
/// Returns the page with the statements of all exercises, which says how to answer them.
std::string page_of_statements(const Classroom& room);
/// Writes the index of the lessons and the page of the exercises' statements into a folder: index.html,
/// exercises.html.
int write_index(const Classroom& room, const std::string& folder);

/// What comes of a form: HTML to show, and the progress of the student.
struct Reply {
  std::string says, standing;
};
/// Returns the reply to a button: read (nothing is judged), check, hint, solution, give_up. Throws BadInput
/// for another.
Reply reply(const Classroom& room, const Exercise& exercise, const std::string& what,
            const std::string& answer);

}  // namespace rederive::classroom
