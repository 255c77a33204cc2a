#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <derivations/program/program.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/exercises/terms.hpp>
#include <lessons/page/prose.hpp>
#include <regex>
#include <set>

namespace rederive::classroom {
using namespace language;
using namespace decide;
using namespace program;
using namespace paper;
using namespace page;
namespace {

std::string symbol_table(const Exercise& exercise) {
  std::string text;
  std::size_t width = 0;
  for (const auto& name : exercise.symbols) width = std::max(width, name.size());
  for (const auto& name : exercise.symbols) {
    const auto* symbol = exercise.language().find(name);
    if (symbol == nullptr)
      throw std::runtime_error("exercise " + exercise.id + ": there is no symbol " + name);
    const std::string unit = symbol->unit == "1" ? "" : ", " + symbol->unit;
    const std::string sign = symbol->unicode == name ? "" : symbol->unicode + "  ";
    text += fmt::format("  {:{}}  {}{}{}\n", name, width, sign, symbol->meaning, unit);
  }
  return text;
}

std::string numbered_terms(const Exercise& exercise) {
  const auto in_unicode = [&](const auto& formula) {
    return print(formula, Notation::unicode, exercise.language());
  };
  const Relation printed = printed_with_slip(exercise.answer, exercise.paper());
  std::string text = fmt::format("  ({})  {}\n\n", exercise.answer.row, in_unicode(printed));
  const auto terms = terms_to_point_at(printed);
  for (std::size_t i = 0; i < terms.size(); ++i)
    text += fmt::format("  [{}]  {}\n", i + 1, in_unicode(terms[i]));
  return text + "\n";
}

/// Returns a page as lines for a terminal.
std::string lines_of(const Page& page) {
  const Symbols& symbols = page.paper().symbols;
  std::string text;
  for (const auto& block : page.blocks()) {
    if (const auto* words = std::get_if<Paragraph>(&block)) text += readable(words->text, symbols, "  ");
    if (const auto* formula = std::get_if<Formula>(&block))
      text +=
          wrap(joined(pieces(formula->relation), " ",
                      [&](const Piece& piece) { return glued(print(piece, Notation::unicode, symbols)); }) +
                   formula->mark,
               80, "      ", "        ");
  }
  return text;
}

}  // namespace

void say(const std::string& text) { std::fputs(text.c_str(), stdout); }
void say_json(const Json& document) {
  say(document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::string readable(const std::string& sentences, const Symbols& symbols, const std::string& indent) {
  std::string text;
  for (const auto& paragraph : paragraphs(sentences)) {
    std::string line;
    for (const auto& span : spans(paragraph))
      line += span.kind == Span::Kind::math   ? glued(print_inline(span.text, Notation::unicode, symbols))
              : span.kind == Span::Kind::code ? glued(span.text)
                                              : span.text;
    text += (text.empty() ? "" : "\n") + wrap(line, 80, indent, indent);
  }
  return text;
}

std::string form_in_words(const Exercise& exercise) {
  constexpr std::array forms{"any equivalent expression", "any equivalent equation",
                             "to {} significant digits", "one letter",
                             "the number of the wrong term, or the term as printed"};
  return fmt::format(fmt::runtime(forms.at(static_cast<std::size_t>(exercise.kind))), exercise.digits);
}

std::string default_example(const Exercise& exercise) {
  if (!exercise.example.empty()) return exercise.example;
  return exercise.kind == Kind::choice ? "b" : "2";
}

std::string pivot_in_words(const Exercise& exercise) {
  if (exercise.kind != Kind::equation) return "";
  return exercise.pivot.empty() ? "left side - right side = " : exercise.pivot + " = ";
}

std::string id_and_seed(const Exercise& exercise) {
  return exercise.seed.empty() ? exercise.id
                               : fmt::format("{} --seed \"{}\"", exercise.id, printable_line(exercise.seed));
}

std::string place_of(const Witness& witness) {
  return joined(witness.at, ", ", [](const auto& one) { return one.first + " = " + one.second; });
}

std::string presentation(const Exercise& exercise) {
  std::string text = fmt::format("{}  (lesson {})\n{}\n\n", exercise.id, exercise.lesson, exercise.title);
  text += readable(exercise.statement, exercise.language()) + "\n";
  if (exercise.kind == Kind::wrong_term) text += numbered_terms(exercise);
  for (std::size_t i = 0; i < exercise.options.size(); ++i)
    text += readable(fmt::format("{}) {}", static_cast<char>('a' + i), exercise.options[i].text),
                     exercise.language(), "  ");
  if (!exercise.options.empty()) text += "\n";
  if (!exercise.symbols.empty()) text += "You may use:\n" + symbol_table(exercise) + "\n";
  text += "Form wanted: " + form_in_words(exercise) + "\n";
  text += "An answer looks like this (for a different question): " + default_example(exercise) + "\n";
  return text + fmt::format("\nTo answer: {1} check {0} \"...\"     for help: {1} hint {0}\n",
                            id_and_seed(exercise), exercise.course->program);
}

Json presentation_json(const Exercise& exercise) {
  Json symbols = Json::array(), options = Json::array();
  for (const auto& name : exercise.symbols) {
    const auto* symbol = exercise.language().find(name);
    symbols.push_back({{"name", name}, {"unit", symbol->unit}, {"meaning", symbol->meaning}});
  }
  for (const auto& option : exercise.options) options.push_back(readable(option.text, exercise.language()));
  return {{"id", exercise.id},
          {"lesson", exercise.lesson},
          {"title", exercise.title},
          {"statement", readable(exercise.statement, exercise.language())},
          {"form", form_in_words(exercise)},
          {"example", default_example(exercise)},
          {"given", exercise.given},
          {"symbols", symbols},
          {"options", options}};
}

std::string report(const Exercise& exercise, const Opinion& opinion, bool lively) {
  std::string text = opinion.line == 0 ? "" : fmt::format("Line {}\n", opinion.line);
  if (!opinion.read_as.empty()) text += wrap(glued(opinion.read_as), 80, "Read as: ", "         ");
  const char* colour = opinion.outcome == Outcome::correct ? "1;32" : "1;33";
  if (opinion.outcome == Outcome::wrong) colour = "1;31";
  const std::string verdict = in_words(opinion.outcome);
  text += (lively ? fmt::format("\033[{}m{}\033[0m", colour, verdict) : verdict) + "\n";
  text += opinion.shows_place ? opinion.feedback + "\n" : readable(opinion.feedback, exercise.language());
  if (text.ends_with("\n\n")) text.pop_back();
  if (opinion.witness) {
    const std::string what = pivot_in_words(exercise);
    const bool is_step = opinion.line != 0;
    text += wrap("at " + place_of(*opinion.witness), 80, "  ", "     ");
    text += fmt::format("  {}{}{}\n", is_step ? "here:   " : "yours: ", what, opinion.witness->printed);
    text += fmt::format("  {}{}{}\n", is_step ? "before: " : "right: ", what, opinion.witness->derived);
  }
  if (exit_code(opinion) == 1)
    text += "Stuck? " + exercise.course->program + " hint " + id_and_seed(exercise) + "\n";
  return text;
}

Json report_json(const Exercise& exercise, const Opinion& opinion) {
  const std::string feedback = feedback_of(opinion);
  Json json{
      {"exercise", exercise.id},
      {"verdict", to_string(opinion.outcome)},
      {"note", opinion.note.word},
      {"read_as", opinion.read_as.empty() ? Json() : Json(opinion.read_as)},
      {"feedback",
       opinion.shows_place ? feedback : as_typed(unmarked(feedback, Notation::plain, exercise.language()))},
      {"witness", nullptr},
      {"score", opinion.score}};
  if (const auto& witness = opinion.witness)
    json["witness"] = {{"at", witness->at}, {"answer", witness->printed}, {"right", witness->derived}};
  if (opinion.line != 0) json["line"] = opinion.line;
  if (!opinion.readings.empty()) json["readings"] = opinion.readings;
  return json;
}

namespace {

/// Writes the derivations of the equations that the question names, except that of the answer.
void argue_named(const Exercise& exercise, Page& page) {
  static const std::regex number(R"(\((\w+)\))");
  const std::string& text = exercise.statement;
  std::set<std::string> done{exercise.answer.derivation, exercise.answer.row};
  for (std::sregex_iterator found(text.begin(), text.end(), number), end; found != end; ++found) {
    const std::string id = (*found)[1];
    if (!exercise.paper().derivations.contains(id) || !done.insert(id).second) continue;
    page.say(fmt::format("The question names ({}), which comes about like this:", id));
    page.argue(*derivation_of(exercise.paper(), id));
  }
}

}  // namespace

Page way_to_answer(const Prepared& prepared) {
  const auto& reference = prepared.exercise.answer;
  const Course& course = *prepared.exercise.course;
  Page page(prepared.exercise.paper());
  for (const std::string& hint : prepared.exercise.hints) page.say(hint);
  argue_named(prepared.exercise, page);
  if (!reference.function.empty()) {
    function_named(reference.function, course).explain(reference.arguments, page);
    return page;
  }
  page.argue(derivation_for(reference, course));
  for (const auto& [words, relation] : prepared.answer.way) {
    page.say(words);
    page.show(relation);
  }
  if (prepared.exercise.kind == Kind::wrong_term) {
    page.say(fmt::format("Of the printed terms, number {} is the wrong one:", prepared.choice));
    page.show(Relation{{terms_to_point_at(prepared.answer.relation).at(prepared.choice - 1)}, {}});
  }
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
