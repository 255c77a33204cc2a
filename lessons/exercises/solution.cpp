// The way to an answer: its derivation, what was done to the result, and at the end the answer itself.
#include <fmt/format.h>

#include <lessons/exercises/classroom.hpp>
#include <lessons/page/lesson.hpp>
#include <lessons/page/prose.hpp>

namespace rederive::classroom {
namespace {

/// A page as lines for a terminal.
std::string lines_of(const Page& page) {
  std::string text;
  for (const auto& block : page.blocks()) {
    if (const auto* words = std::get_if<Paragraph>(&block))
      text += readable(words->text, page.paper().symbols, "  ");
    if (const auto* formula = std::get_if<Formula>(&block))
      text += wrap(joined(pieces(formula->relation, Notation::unicode, page.paper().symbols), " ", glued) +
                       formula->mark,
                   80, "      ", "        ");
  }
  return text;
}

void argue(const Prepared& prepared, Page& page) {
  const auto& reference = prepared.exercise.answer;
  const Course& course = *prepared.exercise.course;
  if (!reference.function.empty())
    return function_named(reference.function, course).explain(reference.arguments, page);
  page.argue(argument_of(reference, course));
  for (const auto& [words, relation] : prepared.answer.way) {
    page.say(words);
    page.show(relation);
  }
  if (prepared.exercise.kind != Kind::wrong_term) return;
  page.say(fmt::format("Of the printed terms, number {} is the wrong one:", prepared.choice));
  page.show(Relation{{terms_to_point_at(prepared.answer.relation).at(prepared.choice - 1)}, {}});
}

}  // namespace

Page way_to_answer(const Prepared& prepared) {
  Page page(prepared.exercise.paper());
  argue(prepared, page);
  return page;
}

std::string solution_text(const Prepared& prepared) {
  const auto& exercise = prepared.exercise;
  std::string text = exercise.title + "\n\nHow it comes about:\n" + lines_of(way_to_answer(prepared)) +
                     "\nSo the answer is\n\n";
  if (exercise.kind == Kind::choice)
    text += readable(exercise.options.at(prepared.choice - 1).text, exercise.language(), "  ") + "\n";
  return text + model_answer(prepared) + "\n";
}

}  // namespace rederive::classroom
