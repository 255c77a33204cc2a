// Turns exercises into passages of a page, for `exercises serve` and for the pages that a teacher hands back.
// The pages show what students wrote as text only.
#pragma once

#include <lessons/exercises/classroom.hpp>
#include <lessons/page/passages.hpp>
#include <map>
#include <optional>
#include <string>

namespace rederive::classroom {

/// Returns the beginning of a text, at most `most` bytes, in printable characters.
std::string cut(const std::string& text, std::size_t most);
/// Returns such a beginning as a sentence that shows it as it was typed.
std::string as_code(const std::string& text, std::size_t most = 2000);
/// Returns the paragraphs of a text with marks as sentences. A paragraph with a formula that cannot be read
/// becomes plain text.
std::vector<std::string> sentences_of(const std::string& text, const language::Symbols& symbols);
/// Returns the opinion of the judge on an answer.
page::Findings verdict_findings(const Opinion& opinion, const language::Symbols& symbols);

/// What answers the buttons of a page.
struct ServedBy {
  bool is_module = false;  ///< a module of WebAssembly in the page; false: `exercises serve`
  bool has_mathlive =
      false;  ///< whether formulas are typed into a field of MathLive, which lies beside the page
  /// The files of the paper's folder by their names, for a module that does not know the paper.
  std::map<std::string, std::string> files = {};
};
/// Returns the forms of all exercises, and the script that serves them, as the option --forms of a lesson
/// reads them.
std::string forms_json(const Classroom& room, const ServedBy& desk = {});
/// Returns the page of all exercises, lesson by lesson, with the student's progress. `titles` maps the
/// programs of the lessons, in order, to their titles.
std::string page_of_exercises(const Classroom& room, const std::map<std::string, std::string>& titles,
                              const ServedBy& desk = {});
/// Returns the page with the statements of all exercises, which says how to answer them.
std::string page_of_statements(const Classroom& room);
/// Writes index.html, which lists the lessons, and exercises.html, which has the statements of the exercises,
/// into a folder. Returns the exit code.
int write_index(const Classroom& room, const std::string& folder);

/// The answer to a form: HTML to show, the progress of the student and, if the button judges, the opinion.
struct Reply {
  std::string says, standing;
  std::optional<Opinion> opinion;
};
/// Returns the reply to a button: read (nothing is judged), form (the form itself, in the variant of the
/// room), check, working, hint, solution, give_up, reset. Throws BadInput for any other.
Reply reply(const Classroom& room, const Exercise& exercise, const std::string& what,
            const std::string& answer);

}  // namespace rederive::classroom
