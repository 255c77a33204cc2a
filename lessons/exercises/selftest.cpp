#include <fmt/format.h>

#include <algorithm>
#include <derivations/program/program.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/selftest.hpp>
#include <lessons/exercises/show.hpp>
#include <lessons/page/prose.hpp>
#include <set>

namespace rederive::classroom {
using namespace language;
using namespace decide;
using namespace program;
using namespace paper;
using namespace page;
namespace {

struct Complaints {
  std::string id;
  std::size_t checks = 0;
  std::vector<std::string> complaints = {};

  void check(bool holds, const std::string& complaint) {
    ++checks;
    if (!holds) complaints.push_back(id + ": " + complaint);
  }
};

std::string got(const Opinion& opinion) {
  return fmt::format("{} ({})", to_string(opinion.outcome), opinion.note.word);
}

/// Returns whether a formula in the sentence equals the answer.
bool gives_away(const Prepared& prepared, const std::string& sentence) {
  for (const auto& span : spans(sentence)) {
    if (span.kind == Span::Kind::text) continue;
    if (prepared.exercise.asks_for_formula() && span.kind == Span::Kind::math &&
        judge_answer(prepared, span.text).score > 0.9)
      return true;
  }
  if (prepared.exercise.kind != Kind::number) return false;
  return sentence.find(fmt::format("{:.3g}", prepared.answer.number)) != std::string::npos;
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
    findings.check(!gives_away(prepared, text), "a hint contains the answer: " + text);
  }
  for (const auto& slip : exercise.slips)
    for (const auto& text : {slip.says, slip.hint})
      findings.check(!gives_away(prepared, text), "the feedback contains the answer: " + text);
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

}  // namespace

int selftest(const Classroom& room) {
  std::size_t checks = 0, variants = 0;
  std::vector<std::string> complaints;
  std::set<std::pair<std::string, Choice>> seen;
  const auto test = [&](const Exercise& exercise) {
    if (!seen.emplace(exercise.id, exercise.choice).second) return;
    variants += !exercise.choice.empty();
    Complaints findings{id_and_seed(exercise)};
    try {
      const Prepared prepared = prepare(exercise);
      check_texts(prepared, findings);
      check_right_answers(prepared, findings);
      check_wrong_answers(prepared, findings);
    } catch (const std::exception& error) {
      findings.check(false, error.what());
    }
    checks += findings.checks;
    complaints.insert(complaints.end(), findings.complaints.begin(), findings.complaints.end());
    if (is_lively(2)) std::fprintf(stderr, "\r%-40s", exercise.id.c_str());
  };
  for (const auto& exercise : room.exercises) test(exercise);
  for (int seed = 1; seed <= 20; ++seed)
    for (const auto& exercise : read_exercises(room.course, room.course.exercises, std::to_string(seed)))
      test(exercise);
  if (is_lively(2)) std::fputs("\r", stderr);
  if (room.json) {
    say_json(Json{{"exercises", room.exercises.size()},
                  {"variants", variants},
                  {"checks", checks},
                  {"complaints", complaints}});
  } else {
    for (const auto& complaint : complaints) say(complaint + "\n");
    say(fmt::format("{}, {}, {}, {}\n", counted(room.exercises.size(), "exercise"),
                    counted(variants, "variant"), counted(checks, "check"),
                    counted(complaints.size(), "complaint")));
  }
  return complaints.empty() ? as_expected : not_as_expected;
}

}  // namespace rederive::classroom
