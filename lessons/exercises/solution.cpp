// The way to an answer: its derivation, what was done to the result, and at the end the answer itself.
#include <fmt/format.h>

#include <cmath>
#include <lessons/exercises/classroom.hpp>
#include <lessons/exercises/functions.hpp>
#include <lessons/page/lesson.hpp>
#include <lessons/page/prose.hpp>

namespace rederive::classroom {
namespace {

/// A page as lines for a terminal.
std::string lines_of(const Page& page) {
  std::string text;
  for (const auto& block : page.blocks()) {
    if (const auto* words = std::get_if<Paragraph>(&block)) text += readable(words->text, "  ");
    if (const auto* formula = std::get_if<Formula>(&block))
      text += wrap(joined(pieces(formula->relation, Notation::unicode), " ", glued) + formula->mark, 80,
                   "      ", "        ");
  }
  return text;
}

/// The conditions behind a number of the numerics, and their solution.
void argue_by_conditions(const Reference& reference, Page& page) {
  const Conditions found = conditions_behind(reference.function, reference.arguments);
  for (const auto& id : found.rows) {
    page.say(fmt::format("Derived is ({}):", id));
    page.result(id);
  }
  const std::string with = joined(reference.arguments, ", ", [](const auto& given) {
    return fmt::format("${} = {:.10g}$", given.first == "omega" ? "omega_p/p" : given.first, given.second);
  });
  std::string loss;
  if (const auto alpha = reference.arguments.find("alpha"); alpha != reference.arguments.end())
    loss = fmt::format(" and $e = {:.8g}$ from (46)",
                       number_of(derived("46b").right, {{"alpha", std::to_string(alpha->second)}}));
  page.say(fmt::format(
      "With {}{}, {} by $psi = {:.8g}${}.", with, loss,
      found.rows.size() == 1 ? "it is solved" : "they are solved", found.psi,
      found.impact_time ? fmt::format(" and an impact at $p*t = {:.8g}$", *found.impact_time) : ""));
  page.say("The block lifts when $a_p*sin(psi) = alpha*g$. So the amplitude in units of $alpha*g$ is");
  page.show(parse_relation(fmt::format("1/sin({:.8g}) = {:.8g}", found.psi, 1 / std::sin(found.psi))));
}

void argue(const Prepared& prepared, Page& page) {
  const auto& reference = prepared.exercise.answer;
  if (!reference.function.empty()) return argue_by_conditions(reference, page);
  page.argue(reference.derivation.empty() ? derived(reference.row) : argument_of(reference));
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
  Page page;
  argue(prepared, page);
  return page;
}

std::string solution_text(const Prepared& prepared) {
  const auto& exercise = prepared.exercise;
  std::string text = exercise.title + "\n\nHow it comes about:\n" + lines_of(way_to_answer(prepared)) +
                     "\nSo the answer is\n\n";
  if (exercise.kind == Kind::choice)
    text += readable(exercise.options.at(prepared.choice - 1).text, "  ") + "\n";
  return text + model_answer(prepared) + "\n";
}

}  // namespace rederive::classroom
