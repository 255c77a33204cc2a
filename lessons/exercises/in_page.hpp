// Exercises as HTML: in the pages of `exercises serve`, and in those that a teacher hands back. What students
// wrote is only ever text in them.
#pragma once

#include <lessons/exercises/classroom.hpp>
#include <map>
#include <string>

namespace rederive::classroom {

/// The beginning of a text that may be of any length and hold anything.
std::string shown(const std::string& text, std::size_t most);
/// Sentences with marks.
std::string in_html(const std::string& sentences, const Symbols& symbols);
/// What the judge says; `more` is HTML.
std::string verdict_html(const Opinion& opinion, const Symbols& symbols, const std::string& more);

/// The page of a lesson, its exercises in their places, with a form each.
std::string with_exercises(const Classroom& room, std::string page);
/// All exercises, lesson by lesson, with what is done. `contents` by the lessons' programs, in order.
std::string page_of_exercises(const Classroom& room, const std::map<std::string, std::string>& contents);

/// What comes of a form: HTML to show, and where the student stands.
struct Reply {
  std::string says, standing;
};
/// `what`: read (nothing is judged), check, hint, solution, give_up. Throws BadInput for another.
Reply reply(const Classroom& room, const Exercise& exercise, const std::string& what,
            const std::string& answer);

}  // namespace rederive::classroom
