// What the classroom says to a student, as text for a terminal and as JSON.
#pragma once

#include <lessons/exercises/prepared.hpp>
#include <lessons/page/lesson.hpp>
#include <nlohmann/json.hpp>
#include <string>

namespace rederive::classroom {

using Json = nlohmann::ordered_json;

/// Write to standard output: a text as it is, and a document with a line end.
void say(const std::string& text);
void say_json(const Json& document);

/// Returns sentences with marks as lines of at most 80 columns.
std::string readable(const std::string& sentences, const language::Symbols& symbols,
                     const std::string& indent = "");
/// Returns what is asked for, "to 3 significant digits", and an answer to another question.
std::string form_in_words(const Exercise& exercise);
std::string default_example(const Exercise& exercise);
/// Returns what has a value at a point, if the answer is an equation: "thetaddot = ".
std::string pivot_in_words(const Exercise& exercise);
/// Returns what a command must be given: the id, and the seed of a variant.
std::string id_and_seed(const Exercise& exercise);
/// Returns where a witness is: "R = 3, alpha = 0.2".
std::string place_of(const decide::Witness& witness);

/// Returns the statement with all that is needed to answer it.
std::string presentation(const Exercise& exercise);
Json presentation_json(const Exercise& exercise);
/// Returns what was read, the verdict, the feedback and the witness; `lively` allows colour.
std::string report(const Exercise& exercise, const Opinion& opinion, bool lively);
Json report_json(const Exercise& exercise, const Opinion& opinion);
/// Returns how the answer comes about: the way of the hints, the equations that the question names, and the
/// derivation of the answer.
page::Page way_to_answer(const Prepared& prepared);
/// Returns the same for a terminal; the last line is the answer, in the form that is asked for.
std::string solution_text(const Prepared& prepared);

}  // namespace rederive::classroom
