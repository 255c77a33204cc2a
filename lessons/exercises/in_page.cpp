#include <fmt/format.h>

#include <derivations/paper/prove.hpp>
#include <derivations/program/bounded.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/in_page.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/judge_formula.hpp>
#include <lessons/exercises/judge_number.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/exercises/terms.hpp>
#include <lessons/exercises/units.hpp>
#include <lessons/exercises/working.hpp>
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>
#include <lessons/page/run_lesson.hpp>
#include <nlohmann/json.hpp>

namespace rederive::classroom {
using namespace language;
using namespace decide;
using namespace program;
using namespace paper;
using namespace page;
namespace {

std::string in_html(const Paper& paper, const std::vector<Passage>& passages) {
  return html_renderer({.paper = paper, .format = Format::html})->passages(passages);
}

std::string inline_math(const Relation& relation) {
  return "$" + print_statement(relation, Notation::plain, {}) + "$";
}

/// Writes lines of which one has a caret that must keep its place.
Remark lines_of(const std::string& text) { return {.label = "", .verbatim = cut(text, 2000)}; }

std::vector<Remark> remarks_of(const std::string& text, const Symbols& symbols) {
  std::vector<Remark> remarks;
  for (const std::string& sentence : sentences_of(text, symbols))
    remarks.push_back({.label = "", .words = sentence});
  return remarks;
}

std::string standing(const Record& record) {
  const std::string status = record.status == Status::given_up ? "given up" : to_string(record.status);
  return status + ", " + counted(static_cast<std::size_t>(record.attempts), "attempt");
}

/// Returns the statement of an exercise, with the symbols that an answer may use.
std::vector<Passage> statement_of(const Exercise& exercise) {
  std::vector<Passage> passages;
  for (const std::string& sentence : sentences_of(exercise.statement, exercise.language()))
    passages.push_back(Paragraph{sentence});
  if (exercise.kind == Kind::wrong_term)
    passages.push_back(Formula{printed_with_slip(exercise.answer, exercise.paper()), exercise.answer.row});
  Table symbols{.header = {}, .rows = {}, .summary = "You may use"};
  for (const auto& name : exercise.symbols)
    if (const auto* symbol = exercise.language().find(name))
      symbols.rows.push_back({as_code(name), "$" + name + "$",
                              literal(symbol->meaning + (symbol->unit == "1" ? "" : ", " + symbol->unit))});
  if (!symbols.rows.empty()) passages.push_back(symbols);
  return passages;
}

/// Returns an exercise with its form. `reply` understands the buttons.
ExerciseForm form_of(const Exercise& exercise, const Progress& progress, bool open) {
  ExerciseForm form{.id = exercise.id,
                    .title = exercise.title,
                    .standing = standing(record_of(progress, exercise)),
                    .statement = statement_of(exercise),
                    .choices = {},
                    .prompt = fmt::format("Your answer, {}. It looks like {} (for a different question).",
                                          form_in_words(exercise), as_code(default_example(exercise))),
                    .is_open = open};
  form.has_working =
      exercise.asks_for_formula() || (exercise.kind == Kind::number && exercise.answer.function.empty());
  for (const auto& name : exercise.asks_for_formula() ? exercise.symbols : std::vector<std::string>())
    if (const auto* symbol = exercise.language().find(name)) form.symbols.emplace_back(name, symbol->latex);
  for (const auto& option : exercise.options) {
    const char letter = static_cast<char>('a' + form.choices.size());
    form.choices.emplace_back(std::string(1, letter),
                              joined(sentences_of(option.text, exercise.language()), " "));
  }
  if (exercise.kind == Kind::wrong_term)
    for (const auto& term : terms_to_point_at(printed_with_slip(exercise.answer, exercise.paper())))
      form.choices.emplace_back(std::to_string(form.choices.size() + 1), inline_math({{term}, {}}));
  return form;
}

/// Returns the script of the forms, with what it knows of the page.
std::string script(const Classroom& room, const ServedBy& desk) {
  nlohmann::json ids = nlohmann::json::array();
  for (const auto& exercise : room.exercises) ids.push_back(exercise.id);
  const nlohmann::json site{{"paper", room.course.paper.title},
                            {"exercises", ids},
                            {"judge", desk.is_module},
                            {"mathlive", desk.has_mathlive},
                            {"files", desk.files}};
  std::string text = "const site = " + site.dump() + ";\n";
  for (std::size_t at = 0; (at = text.find("</", at)) != std::string::npos; at += 3)
    text.insert(at + 1, "\\");  // "</script>" in a title would end the script
  for (const char* file :
       {"desk_of_server", "desk_of_module", "formula_field", "report_to_school", "exercise"})
    text += read_whole(exercises_folder() / (std::string(file) + ".js"));
  return text;
}

/// Returns what is read while a student types, by a process of its own.
std::string read_back(const Exercise& exercise, const std::string& text) {
  const auto work = [&]() -> std::string {
    try {
      if (exercise.kind == Kind::number)
        return in_html(
            exercise.paper(),
            {Paragraph{"Read as: " + as_code(parse_quantity(without_name(exercise, text)).read_as)}});
      const reader::Readings readings = read_answer(exercise, text);
      std::string html = "Read as: ";
      for (const Relation& read : readings.all)
        html += fmt::format("{}<span data-plain=\"{}\" data-latex=\"{}\">{}</span>",
                            &read == &readings.all.front() ? "" : " or ",
                            escaped(print_statement(read, Notation::plain, {})),
                            escaped(print_statement(read, Notation::latex, exercise.language())),
                            formula_html(read, exercise.language()));
      return html + (readings.all.size() > 1 ? ". It is not clear " + readings.reason + "." : "");
    } catch (const SyntaxError& error) {
      return in_html(exercise.paper(), {Findings{"", {lines_of(explain(error, text) + "\n")}}});
    }
  };
  const Bounded outcome = run_bounded(work, 5, 480);
  return outcome.result ? *outcome.result : "This could not be read: " + escaped(outcome.why) + ".";
}

std::string next_sentence(const Classroom& room, const Progress& progress) {
  const Exercise* next = next_exercise(room, progress);
  return fmt::format("{} of {} solved. {}", count_of(room, progress, Status::solved), room.exercises.size(),
                     next == nullptr
                         ? "That was the last one."
                         : "Next: [" + literal(next->title) + "](exercises.html#" + next->id + ")");
}

Findings checked(const Classroom& room, const Exercise& exercise, const Opinion& opinion,
                 const std::string& answer, Progress& progress) {
  const std::string trouble = keep(room, exercise, opinion, answer, progress);
  Findings said = verdict_findings(opinion, exercise.language());
  const auto add = [&](const std::string& label, const std::string& words) {
    said.lines.push_back({.label = label, .words = words});
  };
  if (opinion.witness) {
    const std::string what = pivot_in_words(exercise);
    add("", "At " + as_code(place_of(*opinion.witness)));
    add("yours", as_code(what + opinion.witness->printed));
    add("right", as_code(what + opinion.witness->derived));
  }
  if (!trouble.empty()) add("", "But " + literal(trouble));
  if (opinion.outcome == Outcome::correct) add("", next_sentence(room, progress));
  return said;
}

Findings hinted(const Classroom& room, const Exercise& exercise) {
  const Hint hint = next_hint(room, exercise);
  Findings said{cut(hint.head, 400), remarks_of(hint.text, exercise.language()), "said"};
  if (!hint.is_new) said.lines.push_back({.label = "", .words = "That was the last hint."});
  return said;
}

std::vector<Passage> solved(const Classroom& room, const Exercise& exercise, bool gives_up,
                            Progress& progress) {
  if (!solution_is_due(room, exercise, gives_up, progress))
    return {Buttons{"This is not solved yet. Try again, ask for a hint, or ", {{"give_up", "give up"}}}};
  const Prepared prepared = prepare(exercise);
  std::vector<Passage> passages = way_to_answer(prepared).blocks();
  passages.push_back(Paragraph{"So the answer is " + as_code(model_answer(prepared))});
  return passages;
}

}  // namespace

std::string cut(const std::string& text, std::size_t most) {
  std::size_t end = std::min(most, text.size());
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return printable(text.substr(0, end)) + (end < text.size() ? " …" : "");
}

std::string as_code(const std::string& text, std::size_t most) {
  return "`" + literal(cut(text, most)) + "`";
}

std::vector<std::string> sentences_of(const std::string& text, const Symbols& symbols) {
  std::vector<std::string> sentences;
  for (const std::string& paragraph : paragraphs(printable(text))) try {
      (void)unmarked(paragraph, Notation::plain, symbols);
      sentences.push_back(paragraph);
    } catch (const std::exception&) {  // a student's formula
      sentences.push_back(literal(cut(paragraph, 2000)));
    }
  return sentences;
}

Findings verdict_findings(const Opinion& opinion, const Symbols& symbols) {
  Findings said{in_words(opinion.outcome), {}, "said " + to_string(opinion.outcome)};
  if (!opinion.read_as.empty()) said.lines.push_back({.label = "Read as", .words = as_code(opinion.read_as)});
  if (opinion.shows_place)
    said.lines.push_back(lines_of(opinion.feedback));
  else
    std::ranges::move(remarks_of(opinion.feedback, symbols), std::back_inserter(said.lines));
  return said;
}

std::string forms_json(const Classroom& room, const ServedBy& desk) {
  const Progress progress = desk.is_module ? Progress() : load_progress(room.progress);
  nlohmann::json forms = nlohmann::json::array();
  for (const auto& exercise : room.exercises)
    forms.push_back({{"id", exercise.id},
                     {"lesson", exercise.lesson},
                     {"html", in_html(exercise.paper(), {form_of(exercise, progress, true)})}});
  return nlohmann::json{{"forms", forms}, {"script", script(room, desk)}}.dump();
}

std::string page_of_exercises(const Classroom& room, const std::map<std::string, std::string>& titles,
                              const ServedBy& desk) {
  const Progress progress = desk.is_module ? Progress() : load_progress(room.progress);
  std::vector<Passage> passages{desk.is_module ? Paragraph{"[All lessons](index.html)"}
                                               : Paragraph{next_sentence(room, progress)}};
  int number = 0;
  for (const auto& [lesson, title] : titles) {
    passages.push_back(Heading{"[" + literal(title) + "](" + lesson + ".html)"});
    ++number;
    for (const auto& exercise : room.exercises)
      if (exercise.lesson == number) passages.push_back(form_of(exercise, progress, false));
  }
  if (desk.is_module) passages.push_back(Heading{"Your answers", 0, "answers"});
  if (room.course.lessons.has_workbench)
    passages.push_back(Paragraph{"[The workbench](workbench.html): the block in motion"});
  return rendered({"The lessons and their exercises"}, passages,
                  {.paper = room.course.paper, .format = Format::html, .script = script(room, desk)});
}

std::string page_of_statements(const Classroom& room) {
  std::vector<Passage> exercises{
      Paragraph{"[All lessons](index.html)"},
      Paragraph{
          fmt::format("They are worked in the lessons: `{}` prints an address to open. Or at a terminal: "
                      "`{}` judges an answer, `exercises hint ID` helps.",
                      command_on(room.course.paper, "exercises serve"),
                      command_on(room.course.paper, "exercises check ID \"ANSWER\""))}};
  for (const auto& exercise : room.exercises) {
    exercises.push_back(Heading{literal(exercise.title), 0, exercise.id});
    exercises.push_back(Paragraph{fmt::format("`{}`, lesson {}", exercise.id, exercise.lesson)});
    for (Passage& passage : statement_of(exercise)) exercises.push_back(std::move(passage));
    const ExerciseForm form = form_of(exercise, {}, false);
    BulletList choices;
    for (const auto& [value, sentence] : form.choices) choices.items.push_back(value + ") " + sentence);
    exercises.push_back(form.choices.empty() ? Passage(Paragraph{form.prompt}) : Passage(choices));
  }
  return rendered({"The exercises"}, exercises, {.paper = room.course.paper, .format = Format::html});
}

int write_index(const Classroom& room, const std::string& folder) {
  const Setting setting{.paper = room.course.paper, .format = Format::html};
  BulletList lessons;
  for (const auto& [lesson, title] : room.course.lessons.titles())
    lessons.items.push_back("[" + literal(title) + "](" + lesson + ".html)");
  write_whole(
      std::filesystem::path(folder) / "index.html",
      rendered(
          {"The rocking block"},
          {Paragraph{
               "A paper rederived, equation by equation, in lessons: how a block standing on its own weight "
               "rocks, and when it falls. Each page was computed when it was written."},
           lessons,
           Paragraph{
               "[The workbench](workbench.html): the block in motion, and the map of what overturns it."},
           Paragraph{"[The exercises](exercises.html)"}},
          setting));
  write_whole(std::filesystem::path(folder) / "exercises.html", page_of_statements(room));
  return as_expected;
}

Reply reply(const Classroom& room, const Exercise& exercise, const std::string& what,
            const std::string& answer) {
  Progress progress = load_progress(room.progress);
  const auto html = [&](const std::vector<Passage>& passages) { return in_html(exercise.paper(), passages); };
  std::string text;
  std::optional<Opinion> opinion;
  std::string given = answer;
  std::optional<Working> working;
  if (what == "check") opinion = judge_bounded(exercise, answer);
  if (what == "working") {
    working = judge_working(exercise, numbered_lines(answer), bounded);
    opinion = working->opinion;
    given = working->answer;
  }
  if (what == "read")
    text = answer.empty() ? "" : read_back(exercise, answer);
  else if (opinion)
    text = html({checked(room, exercise, *opinion, given, progress)}) +
           (working ? html({Findings{"", {lines_of(working_text(*working))}}}) : "");
  else if (what == "form")
    text = html({form_of(exercise, progress, true)});
  else if (what == "reset")
    (void)open_again(room, exercise);
  else if (what == "hint")
    text = html({hinted(room, exercise)});
  else if (what == "solution" || what == "give_up")
    text = html(solved(room, exercise, what == "give_up", progress));
  else
    throw BadInput("the button must be check, working, hint, solution, give_up, reset, read or form, not '" +
                   what + "'");
  if (what != "read") progress = load_progress(room.progress);
  return {text, "(" + standing(record_of(progress, exercise)) + ")", opinion};
}

}  // namespace rederive::classroom
