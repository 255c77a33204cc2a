// What the classroom says to a student.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <derivations/program/program.hpp>
#include <lessons/exercises/classroom.hpp>
#include <lessons/page/lesson.hpp>
#include <lessons/page/prose.hpp>
#include <nlohmann/json.hpp>

namespace rederive::classroom {

std::string form_in_words(const Exercise& exercise) {
  constexpr std::array forms{"any equivalent expression", "any equivalent equation",
                             "to {} significant digits", "one letter",
                             "the number of the wrong term, or the term as printed"};
  return fmt::format(fmt::runtime(forms.at(static_cast<std::size_t>(exercise.kind))), exercise.digits);
}

std::string default_example(const Exercise& exercise) {
  return !exercise.example.empty() ? exercise.example : exercise.kind == Kind::choice ? "b" : "2";
}

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
  const Relation printed = printed_with_slip(exercise.answer, exercise.paper());
  std::string text = fmt::format("  ({})  {}\n\n", exercise.answer.row,
                                 print(printed, Notation::unicode, exercise.language()));
  const auto terms = terms_to_point_at(printed);
  for (std::size_t i = 0; i < terms.size(); ++i)
    text += fmt::format("  [{}]  {}\n", i + 1, print(terms[i], Notation::unicode, exercise.language()));
  return text + "\n";
}

std::string colour(const Classroom& room, const std::string& code, const std::string& text) {
  return room.lively ? "\033[" + code + "m" + text + "\033[0m" : text;
}

}  // namespace

std::string pivot_in_words(const Exercise& exercise) {
  return exercise.kind != Kind::equation ? ""
         : exercise.pivot.empty()        ? "left side - right side = "
                                         : exercise.pivot + " = ";
}

std::string place_of(const Witness& witness) {
  return joined(witness.at, ", ", [](const auto& one) { return one.first + " = " + one.second; });
}

std::string verdict_in_words(const std::string& verdict) {
  if (verdict == "correct") return "Correct.";
  if (verdict == "wrong_form") return "The value is right, but the form is not.";
  if (verdict == "correct_if") return "Correct only under a condition.";
  if (verdict == "wrong") return "Not right yet.";
  if (verdict == "invalid") return "This could not be read; it does not count as an attempt.";
  return "Undecided.";
}

std::string readable(const std::string& sentence, const Symbols& symbols, const std::string& indent) {
  std::string text;
  for (const auto& paragraph : paragraphs(sentence)) {
    std::string line;
    for (const auto& span : spans(paragraph))
      line += span.kind == Span::Kind::math   ? glued(print_inline(span.text, Notation::unicode, symbols))
              : span.kind == Span::Kind::code ? glued(span.text)
                                              : span.text;
    text += (text.empty() ? "" : "\n") + wrap(line, 80, indent, indent);
  }
  return text;
}

std::string id_and_seed(const Exercise& exercise) {
  return exercise.seed.empty() ? exercise.id
                               : fmt::format("{} --seed \"{}\"", exercise.id, printable_line(exercise.seed));
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
  return text + fmt::format("\nTo answer: exercises check {0} \"...\"     for help: exercises hint {0}\n",
                            id_and_seed(exercise));
}

std::string report(const Classroom& room, const Exercise& exercise, const Opinion& opinion) {
  std::string text = opinion.line == 0 ? "" : fmt::format("Line {}\n", opinion.line);
  if (!opinion.read_as.empty()) text += wrap(glued(opinion.read_as), 80, "Read as: ", "         ");
  const std::string code = opinion.verdict == "correct" ? "1;32"
                           : opinion.verdict == "wrong" ? "1;31"
                                                        : "1;33";
  text += colour(room, code, verdict_in_words(opinion.verdict)) + "\n";
  const bool several_lines = opinion.feedback.find('\n') != std::string::npos;  // a caret must keep its place
  if (opinion.verdict != "correct" || opinion.feedback != "Right.")
    text += several_lines ? opinion.feedback + "\n" : readable(opinion.feedback, exercise.language());
  if (text.ends_with("\n\n")) text.pop_back();
  if (opinion.witness) {
    text += wrap("at " + place_of(*opinion.witness), 80, "  ", "     ");
    const std::string what = pivot_in_words(exercise);
    const bool is_step = opinion.line != 0;
    text +=
        fmt::format("  {}{}{}\n  {}{}{}\n", is_step ? "here:   " : "yours: ", what, opinion.witness->printed,
                    is_step ? "before: " : "right: ", what, opinion.witness->derived);
  }
  if (exit_code(opinion) == 1) text += "Stuck? exercises hint " + id_and_seed(exercise) + "\n";
  return text;
}

std::string report_json(const Exercise& exercise, const Opinion& opinion) {
  nlohmann::ordered_json json{
      {"exercise", exercise.id}, {"verdict", opinion.verdict}, {"note", opinion.note}};
  json["read_as"] =
      opinion.read_as.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(opinion.read_as);
  const bool several_lines = opinion.feedback.find('\n') != std::string::npos;
  json["feedback"] = several_lines
                         ? opinion.feedback
                         : as_typed(unmarked(opinion.feedback, Notation::plain, exercise.language()));
  json["witness"] = nullptr;
  if (opinion.witness)
    json["witness"] = {{"at", opinion.witness->at},
                       {"answer", opinion.witness->printed},
                       {"right", opinion.witness->derived}};
  json["score"] = opinion.score;
  if (opinion.line != 0) json["line"] = opinion.line;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

int show(const Classroom& room, const std::string& id) {
  const Exercise* exercise =
      id.empty() ? next_exercise(room, load_progress(room.progress)) : &find_exercise(room, id);
  if (exercise == nullptr) {
    std::fputs("All exercises are done. Read one again with: exercises show ID\n", stdout);
    return as_expected;
  }
  if (!room.json) {
    std::fputs(presentation(*exercise).c_str(), stdout);
    return as_expected;
  }
  nlohmann::ordered_json json{{"id", exercise->id},
                              {"lesson", exercise->lesson},
                              {"title", exercise->title},
                              {"statement", readable(exercise->statement, exercise->language())},
                              {"form", form_in_words(*exercise)},
                              {"example", default_example(*exercise)},
                              {"given", exercise->given},
                              {"symbols", nlohmann::ordered_json::array()},
                              {"options", nlohmann::ordered_json::array()}};
  for (const auto& name : exercise->symbols) {
    const auto* symbol = exercise->language().find(name);
    json["symbols"].push_back({{"name", name}, {"unit", symbol->unit}, {"meaning", symbol->meaning}});
  }
  for (const auto& option : exercise->options)
    json["options"].push_back(readable(option.text, exercise->language()));
  std::fputs((json.dump(2) + "\n").c_str(), stdout);
  return as_expected;
}

}  // namespace rederive::classroom
