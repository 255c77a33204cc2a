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
#include <lessons/page/prose.hpp>
#include <lessons/page/render.hpp>

namespace rederive::classroom {
namespace {

std::string code(const std::string& text) { return "<code>" + shown(text, 2000) + "</code>"; }

/// A formula that may be a student's: where it cannot be drawn, as text.
std::string drawn(const Relation& relation, const Symbols& symbols) {
  try {
    return formula_html(relation, symbols);
  } catch (const std::exception&) {
    return code(print_statement(relation, Notation::unicode, symbols));
  }
}

/// A sentence with marks; one with a formula that cannot be drawn, as text.
std::string line_html(const std::string& sentence, const Symbols& symbols) {
  try {
    return sentence_html(sentence, symbols,
                         [](const std::string& words) { return escaped(printable(words)); });
  } catch (const std::exception&) {
    return shown(sentence, 2000);
  }
}

/// Text whose caret must keep its place.
std::string lines_html(const std::string& text) { return "<pre>" + shown(text, 2000) + "</pre>\n"; }

std::string standing(const Record& record) {
  const std::string status = record.status == Status::given_up ? "given up" : to_string(record.status);
  return fmt::format("{}, {} attempt{}", status, record.attempts, record.attempts == 1 ? "" : "s");
}

std::string symbols_html(const Exercise& exercise) {
  std::string text;
  for (const auto& name : exercise.symbols)
    if (const auto* symbol = exercise.language().find(name))
      text += "<tr><td>" + code(name) + "</td><td>" +
              drawn({{parse(name, exercise.language())}, {}}, exercise.language()) + "</td><td>" +
              escaped(symbol->meaning + (symbol->unit == "1" ? "" : ", " + symbol->unit)) + "</td></tr>\n";
  return text.empty() ? ""
                      : "<details><summary>You may use</summary><div class=\"wide\"><table>\n" + text +
                            "</table></div></details>\n";
}

/// Where the answer goes: one of what is offered, or a line to type into.
std::string field(const Exercise& exercise) {
  std::vector<std::pair<std::string, std::string>> offered;
  for (const auto& option : exercise.options)
    offered.emplace_back(std::string(1, static_cast<char>('a' + offered.size())),
                         line_html(option.text, exercise.language()));
  if (exercise.kind == Kind::wrong_term)
    for (const auto& term : terms_to_point_at(printed_with_slip(exercise.answer, exercise.paper())))
      offered.emplace_back(std::to_string(offered.size() + 1), drawn({{term}, {}}, exercise.language()));
  if (offered.empty())
    return fmt::format(
        "<label for=\"answer-{0}\">Your answer, {1}. It looks like {2} (for a different question).</label>\n"
        "<input id=\"answer-{0}\" name=\"answer\" autocomplete=\"off\" autocapitalize=\"off\" "
        "spellcheck=\"false\" aria-describedby=\"read-{0}\">\n"
        "<output id=\"read-{0}\" for=\"answer-{0}\"></output>\n",
        exercise.id, escaped(form_in_words(exercise)), code(default_example(exercise)));
  std::string text = "<fieldset><legend>Your answer</legend>\n";
  for (const auto& [value, words] : offered)
    text += fmt::format("<label><input type=\"radio\" name=\"answer\" value=\"{0}\"> {0}) {1}</label>\n",
                        value, words);
  return text + "</fieldset>\n";
}

/// An exercise with its form. The buttons are what `reply` understands.
std::string element(const Exercise& exercise, const Progress& progress, bool open) {
  std::string text = fmt::format(
      "<details class=\"exercise\" id=\"{0}\" data-id=\"{0}\"{1}>\n<summary>Exercise: {2} "
      "<span class=\"standing\">({3})</span></summary>\n{4}",
      exercise.id, open ? " open" : "", escaped(exercise.title), standing(record_of(progress, exercise)),
      in_html(exercise.statement, exercise.language()));
  if (exercise.kind == Kind::wrong_term)
    text += fmt::format("<div class=\"formula\"><div>{}</div><span>({})</span></div>\n",
                        drawn(printed_with_slip(exercise.answer, exercise.paper()), exercise.language()),
                        exercise.answer.row);
  return text + symbols_html(exercise) + "<form>\n" + field(exercise) +
         "<p><button value=\"check\">Check</button><button value=\"hint\">Hint</button>"
         "<button value=\"solution\">Solution</button></p>\n"
         "<div class=\"reply\" role=\"status\"></div>\n</form>\n</details>\n";
}

std::string script() {
  return "<script type=\"module\">\n" + read_whole(exercises_folder() / "exercise.js") + "</script>\n";
}

/// What is read while a student types, in a process of its own.
std::string read_back(const Exercise& exercise, const std::string& text) {
  const auto work = [&]() -> std::string {
    try {
      return "Read as: " + (exercise.kind == Kind::number
                                ? code(parse_quantity(without_name(exercise, text)).read_as)
                                : drawn(read_answer(exercise, text), exercise.language()));
    } catch (const SyntaxError& error) {
      return lines_html(explain(error, text) + "\n");
    }
  };
  const Bounded outcome = run_bounded(work, 5, 480);
  return outcome.result ? *outcome.result : "This could not be read: " + escaped(outcome.why) + ".";
}

std::string witness_html(const Exercise& exercise, const Witness& witness) {
  const std::string what = pivot_in_words(exercise);
  return fmt::format("<p>At {}</p>\n<p>yours: {}<br>right: {}</p>\n", code(place_of(witness)),
                     code(what + witness.printed), code(what + witness.derived));
}

std::string next_html(const Classroom& room, const Progress& progress) {
  const Exercise* next = next_exercise(room, progress);
  return fmt::format(
      "<p>{} of {} solved. {}</p>\n", count_of(room, progress, Status::solved), room.exercises.size(),
      next == nullptr ? "That was the last one."
                      : "Next: <a href=\"exercises.html#" + next->id + "\">" + escaped(next->title) + "</a>");
}

}  // namespace

std::string shown(const std::string& text, std::size_t most) {
  std::size_t end = std::min(most, text.size());
  while (end < text.size() && end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80) --end;
  return escaped(printable(text.substr(0, end))) + (end < text.size() ? " …" : "");
}

std::string in_html(const std::string& sentences, const Symbols& symbols) {
  std::string text;
  for (const auto& paragraph : paragraphs(sentences))
    text += "<p>" + line_html(paragraph, symbols) + "</p>\n";
  return text;
}

std::string verdict_html(const Opinion& opinion, const Symbols& symbols, const std::string& more) {
  return fmt::format("<div class=\"said {}\">\n{}<p><b>{}</b></p>\n{}{}</div>\n", to_string(opinion.outcome),
                     opinion.read_as.empty() ? "" : "<p>Read as: " + code(opinion.read_as) + "</p>\n",
                     in_words(opinion.outcome),
                     opinion.shows_place ? lines_html(opinion.feedback) : in_html(opinion.feedback, symbols),
                     more);
}

std::string with_exercises(const Classroom& room, std::string page) {
  const Progress progress = load_progress(room.progress);
  const std::string begin = "<aside class=\"exercise\" data-", end = "</aside>";
  for (std::size_t from = 0; (from = page.find(begin, from)) != std::string::npos;) {
    // data-exercises="ID ID", or data-lesson="N": those of the lesson that have no place yet
    const std::size_t value = page.find('"', from + begin.size()) + 1;
    const std::string asked = " " + page.substr(value, page.find('"', value) - value) + " ";
    std::string elements;
    for (const auto& exercise : room.exercises) {
      const bool is_meant = asked.find(" " + exercise.id + " ") != std::string::npos ||
                            (asked == fmt::format(" {} ", exercise.lesson) &&
                             page.find("data-id=\"" + exercise.id + "\"") == std::string::npos);
      if (is_meant) elements += element(exercise, progress, true);
    }
    page.replace(from, page.find(end, from) + end.size() - from, elements);
  }
  return page.insert(page.rfind("</body>"), script());
}

std::string page_of_exercises(const Classroom& room, const std::map<std::string, std::string>& contents) {
  const Progress progress = load_progress(room.progress);
  std::string text =
      page_head("The exercises") + "<h1>The lessons and their exercises</h1>\n" + next_html(room, progress);
  int number = 0;
  for (const auto& [lesson, list] : contents) {
    text += "<h2><a href=\"" + lesson + ".html\">" + escaped(list.substr(0, list.find('\n'))) + "</a></h2>\n";
    ++number;
    for (const auto& exercise : room.exercises)
      if (exercise.lesson == number) text += element(exercise, progress, false);
  }
  return text + "<p><a href=\"workbench.html\">The workbench</a>: the block in motion</p>\n" + script() +
         "</body>\n</html>\n";
}

Reply reply(const Classroom& room, const Exercise& exercise, const std::string& what,
            const std::string& answer) {
  Progress progress = load_progress(room.progress);
  std::string text;
  if (what == "read") {
    text = answer.empty() ? "" : read_back(exercise, answer);
  } else if (what == "check") {
    const Opinion opinion = judge_bounded(exercise, answer);
    const std::string trouble = keep(room, exercise, opinion, answer, progress);
    text = verdict_html(opinion, exercise.language(),
                        (opinion.witness ? witness_html(exercise, *opinion.witness) : "") +
                            (trouble.empty() ? "" : "<p>But " + escaped(trouble) + "</p>\n") +
                            (opinion.outcome == Outcome::correct ? next_html(room, progress) : ""));
  } else if (what == "hint") {
    const Hint hint = next_hint(room, exercise);
    text = "<div class=\"said\">\n<p><b>" + shown(hint.head, 400) + "</b></p>\n" +
           in_html(hint.text, exercise.language()) + (hint.is_new ? "" : "<p>That was the last hint.</p>\n") +
           "</div>\n";
  } else if (what == "solution" || what == "give_up") {
    if (solution_is_due(room, exercise, what == "give_up", progress)) {
      const Prepared prepared = prepare(exercise);
      text = "<div class=\"said\">\n" + page_html(way_to_answer(prepared)) + "<p>So the answer is " +
             code(model_answer(prepared)) + "</p>\n</div>\n";
    } else {
      text =
          "<p>This is not solved yet. Try again, ask for a hint, or "
          "<button value=\"give_up\">give up</button></p>\n";
    }
  } else {
    throw BadInput("the button must be check, hint, solution, give_up or read, not '" + what + "'");
  }
  if (what != "read") progress = load_progress(room.progress);
  return {text, "(" + standing(record_of(progress, exercise)) + ")"};
}

}  // namespace rederive::classroom
