#include <fmt/format.h>

#include <algorithm>
#include <derivations/program/program.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/said.hpp>
#include <lessons/exercises/selftest.hpp>
#include <lessons/exercises/show.hpp>
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

struct Complaints {
  std::string place;  ///< file, line and exercise
  std::size_t checks = 0;
  std::vector<std::string> complaints = {};

  void check(bool holds, const std::string& complaint) {
    ++checks;
    if (!holds) complaints.push_back(place + ": " + complaint);
  }
};

std::string place_of(const Exercise& exercise) {
  return exercise.place + ": exercise " + id_and_seed(exercise);
}

void add(const Complaints& findings, Report& report) {
  report.checks += findings.checks;
  report.complaints.insert(report.complaints.end(), findings.complaints.begin(), findings.complaints.end());
}

std::string got(const Opinion& opinion) {
  return fmt::format("{} ({})", to_string(opinion.outcome), opinion.note.word);
}

/// Checks what is said to a wrong answer.
void check_said(const Prepared& prepared, const std::string& answer, const Opinion& opinion,
                Complaints& findings) {
  for (const auto& text : {opinion.feedback, opinion.hint}) {
    findings.check(answer_in(prepared, text).empty(), "the feedback contains the answer: " + text);
    const std::string why = untrue(prepared, answer, text);
    findings.check(why.empty(), fmt::format("what is said to {} is not true, {}: {}", answer, why, text));
  }
}

/// Checks that the statement says what is given, and that each inequality in it and in the hints follows from
/// that.
void check_given(const Prepared& prepared, Complaints& findings) {
  const Exercise& exercise = prepared.exercise;
  for (const auto& text : exercise.given)
    findings.check(exercise.statement.find("$" + text + "$") != std::string::npos,
                   "the statement does not say that " + text);
  std::vector<std::string> texts = exercise.hints;
  texts.push_back(exercise.statement);
  for (const auto& text : texts)
    for (const auto& span : spans(text)) {
      if (span.kind != Span::Kind::math || span.text.find_first_of("<>") == std::string::npos) continue;
      const Proof proof =
          decide::decide(parse_statement(span.text, prepared.symbols), parse_relation("0 < 1", {}),
                         prepared.symbols, prepared.answer.given, prepared.assumed);
      findings.check(is_right(proof.verdict), span.text + " is said but not given");
    }
}

void check_texts(const Prepared& prepared, Complaints& findings) {
  const Exercise& exercise = prepared.exercise;
  check_given(prepared, findings);
  findings.check(exercise.hints.size() >= 3, "fewer than three hints");
  for (const auto& text : exercise.hints) {
    findings.check(!text.empty(), "an empty hint");
    findings.check(answer_in(prepared, text).empty(), "a hint contains the answer: " + text);
  }
  for (const auto& option : exercise.options)
    findings.check(option.says.empty() == option.hint.empty(), "an option without a hint: " + option.text);
  findings.check(!exercise.statement.empty(), "no statement");
  findings.check(!presentation(exercise).empty(), "cannot be shown");
  if (exercise.kind != Kind::choice && exercise.kind != Kind::wrong_term)
    findings.check(
        !exercise.example.empty() && judge_answer(prepared, exercise.example).outcome != Outcome::correct,
        "no example of syntax, or one that is right");
}

void check_right_answers(const Prepared& prepared, Complaints& findings) {
  const Exercise& exercise = prepared.exercise;
  const Opinion own = judge_answer(prepared, model_answer(prepared));
  findings.check(own.outcome == Outcome::correct,
                 "its own answer " + model_answer(prepared) + " is " + got(own));
  for (const auto& text : exercise.equivalents) {
    const Opinion opinion = judge_answer(prepared, text);
    findings.check(opinion.outcome == Outcome::correct, text + " is " + got(opinion));
  }
}

void check_wrong_answers(const Prepared& prepared, Complaints& findings) {
  const Exercise& exercise = prepared.exercise;
  for (const std::string stub : {"", "# answer here", "?"})
    findings.check(judge_answer(prepared, stub).outcome == Outcome::invalid,
                   "the stub '" + stub + "' is not refused");
  for (std::size_t i = 0; i < exercise.slips.size(); ++i) {
    const ListedSlip& slip = exercise.slips[i];
    const Road& road = prepared.roads.at(i);
    std::string text = slip.typed;
    if (slip.road)
      text = exercise.kind == Kind::number
                 ? fmt::format("{:.12g} {}", road.number, exercise.unit == "1" ? "" : exercise.unit)
                 : print_statement(road.relation, Notation::plain, prepared.symbols);
    const Opinion opinion = judge_answer(prepared, text);
    findings.check(opinion.outcome == Outcome::wrong && opinion.note.word == slip.note,
                   fmt::format("the slip {}, {}, is {}", slip.note, text, got(opinion)));
    check_said(prepared, text, opinion, findings);
  }
  for (std::size_t i = 0; i < exercise.options.size(); ++i) {
    const Opinion opinion = judge_answer(prepared, std::string(1, static_cast<char>('a' + i)));
    findings.check((opinion.outcome == Outcome::correct) == (i + 1 == prepared.choice),
                   "option " + std::to_string(i + 1) + " is " + got(opinion));
  }
  if (exercise.asks_for_formula() && !exercise.slips.empty() && !exercise.hints.empty())
    findings.check(
        judge_answer(prepared, exercise.kind == Kind::equation ? "1 = 0" : "0").outcome != Outcome::correct,
        "0 passes");
}

/// Checks that examples of the syntax differ from exercise to exercise: who has seen one learns from another.
void check_examples(const Classroom& room, Report& report) {
  std::map<std::string, std::string> seen;
  for (const Exercise& exercise : room.exercises) {
    if (exercise.example.empty()) continue;
    const auto [first, is_new] = seen.emplace(exercise.example, exercise.id);
    Complaints findings{place_of(exercise)};
    findings.check(is_new, fmt::format("its example {} is that of {}", exercise.example, first->second));
    add(findings, report);
  }
}

/// The formulas of a lesson in Markdown, up to where an exercise is mentioned, and all else that it says
/// there.
struct Before {
  std::vector<std::string> formulas;
  std::string words;
};

Before before(const std::string& lesson, const std::string& id) {
  const std::regex mention("Exercise " + id + "(?![\\w-])"),
      formula(R"(\$`([^`]*)`\$|```math\n([^`]*)\n```)"), ending(R"(\\tag\{[^}]*\}|\\,[.,])");
  std::smatch found;
  const std::string text = std::regex_search(lesson, found, mention) ? found.prefix().str() : lesson;
  Before all;
  for (std::sregex_iterator match(text.begin(), text.end(), formula), end; match != end; ++match)
    all.formulas.push_back(std::regex_replace((*match)[(*match)[1].matched ? 1 : 2].str(), ending, ""));
  all.words = text;
  return all;
}

/// Returns what a lesson says before an exercise that is its answer; "" if there is nothing. A symbol alone
/// cannot give an answer away, nor can what the statement says itself.
std::string told_before(const Prepared& prepared, const Before& said) {
  const auto& sides = prepared.answer.relation.sides;
  if (sides.size() == 1 && sides[0]->kind == Node::Kind::symbol) return "";
  if (!answer_in(prepared, prepared.exercise.statement).empty()) return "";
  for (const std::string& formula : said.formulas)
    if (is_the_answer(prepared, formula)) return formula;
  const Reference& answer = prepared.exercise.answer;
  const std::string verdict = "The ledger on (" + answer.row + ")";
  const bool is_found = prepared.exercise.kind == Kind::wrong_term && answer.slip == 0 &&
                        said.words.find(verdict) != std::string::npos;
  return is_found ? verdict : number_in(prepared, said.words);
}

/// Checks that the lesson of an exercise does not tell its answer before it asks.
void check_lessons(const Classroom& room, const std::vector<Exercise>& exercises, Report& report) {
  const auto titles = room.course.lessons.titles();
  for (const Exercise& exercise : room.exercises) {
    Complaints findings{place_of(exercise)};
    findings.check(exercise.lesson <= static_cast<int>(titles.size()),
                   fmt::format("there is no lesson {}", exercise.lesson));
    add(findings, report);
  }
  int number = 0;
  for (const auto& [name, title] : titles) {
    ++number;
    std::string lesson;
    for (const Exercise& exercise : exercises) {
      if (exercise.lesson != number) continue;
      if (lesson.empty()) lesson = room.course.lessons.markdown(name);
      Complaints findings{place_of(exercise)};
      const std::string answer = told_before(prepare(exercise), before(lesson, exercise.id));
      findings.check(answer.empty(), fmt::format("lesson {} gives the answer before it: {}", number, answer));
      add(findings, report);
    }
  }
}

}  // namespace

Report tested(const Classroom& room, bool with_lessons) {
  Report report;
  std::set<std::pair<std::string, Choice>> seen;
  std::vector<Exercise> all;
  const auto test = [&](const Exercise& exercise) {
    if (!seen.emplace(exercise.id, exercise.choice).second) return;
    report.variants += !exercise.choice.empty();
    Complaints findings{place_of(exercise)};
    try {
      const Prepared prepared = prepare(exercise);
      check_texts(prepared, findings);
      check_right_answers(prepared, findings);
      check_wrong_answers(prepared, findings);
      all.push_back(exercise);
    } catch (const std::exception& error) {
      findings.check(false, error.what());
    }
    add(findings, report);
    if (is_lively(2)) std::fprintf(stderr, "\r%-40s", exercise.id.c_str());
  };
  for (const auto& exercise : room.exercises) test(exercise);
  for (int seed = 1; seed <= 20; ++seed)
    for (const auto& exercise : read_exercises(room.course, room.course.exercises, std::to_string(seed)))
      test(exercise);
  check_examples(room, report);
  if (with_lessons) check_lessons(room, all, report);
  return report;
}

int selftest(const Classroom& room, bool with_lessons) {
  const Report report = tested(room, with_lessons);
  if (is_lively(2)) std::fputs("\r", stderr);
  if (room.json) {
    say_json(Json{{"exercises", room.exercises.size()},
                  {"variants", report.variants},
                  {"checks", report.checks},
                  {"complaints", report.complaints}});
  } else {
    for (const auto& complaint : report.complaints) say(complaint + "\n");
    say(fmt::format("{}, {}, {}, {}\n", counted(room.exercises.size(), "exercise"),
                    counted(report.variants, "variant"), counted(report.checks, "check"),
                    counted(report.complaints.size(), "complaint")));
  }
  return report.complaints.empty() ? as_expected : not_as_expected;
}

}  // namespace rederive::classroom
