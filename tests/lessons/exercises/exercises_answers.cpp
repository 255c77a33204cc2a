// What students type, with what must come of it; what is echoed and suggested reads back as promised.
#include <doctest/doctest.h>
#include <fmt/format.h>

#include <lessons/exercises/in_page.hpp>
#include <lessons/exercises/units.hpp>
#include <lessons/page/prose.hpp>
#include <regex>
#include <tests/cases.hpp>

#include "classroom.hpp"

using namespace rederive::language;
using namespace rederive::decide;
using namespace rederive::mechanics;
using namespace rederive::paper;
using namespace rederive::rocking_block;
using namespace rederive::page;
using namespace rederive::classroom;
using namespace rederive::classroom;

namespace {

/// A seed of the exercise in which this is given.
std::string seed_with(const std::string& id, const std::string& given) {
  for (int seed = 1; seed < 100; ++seed)
    if (std::ranges::count(exercise(id, std::to_string(seed)).given, given) > 0) return std::to_string(seed);
  return "";
}

/// Right answers, wrong ones and what is neither, of one exercise, also in spellings of other keyboards.
std::vector<std::string> typed_answers(const Prepared& one) {
  const Exercise& exercise = one.exercise;
  std::vector<std::string> answers = exercise.equivalents;
  answers.push_back(model_answer(one));
  if (!exercise.example.empty()) answers.push_back(exercise.example);
  for (const auto& slip : exercise.slips)
    if (!slip.typed.empty()) answers.push_back(slip.typed);
  if (exercise.kind == Kind::choice || exercise.kind == Kind::wrong_term)
    for (const char* text : {"a", "b", "(C)", "2", "[1]", "term 2"}) answers.emplace_back(text);
  std::vector<std::string> result = answers;
  for (const auto& answer : answers) {
    std::string text = answer;
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"alpha", "α"}, {"theta", "θ"}, {"*", "·"}, {"-", "−"}, {"^2", "²"}, {"sqrt(", "√("}})
      for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    result.push_back(text);
    result.push_back("(" + answer + ")");
    result.push_back("-(" + answer + ")");
    result.push_back("2*(" + answer + ")");
    result.push_back("abs(" + answer + ")");
    result.push_back(std::regex_replace(answer, std::regex(R"(\*)"), " "));
    result.push_back(std::regex_replace(answer, std::regex(R"((sin|cos)\((\w+)\)\^2)"), "$1^2($2)"));
    result.push_back(std::regex_replace(answer, std::regex(R"((sin|cos)\((\w+)\))"), "$1 $2"));
    result.push_back(std::regex_replace(answer, std::regex(R"((\d)\.(\d))"), "$1,$2"));
  }
  if (exercise.kind == Kind::number) {
    const std::string unit = exercise.unit == "1" ? "" : exercise.unit;
    const double value = one.answer.number;
    for (const auto& text : {fmt::format("{:.12g} {} + {:.12g} {}", value / 4, unit, 3 * value / 4, unit),
                             fmt::format("{:.12g} - {:.12g} {}", 5 * value, 4 * value, unit),
                             fmt::format("({:.12g} - {:.12g}) {}", 5 * value, 4 * value, unit)})
      result.push_back(text);
  }
  return result;
}

}  // namespace

TEST_CASE("what is given holds on the other side, too, and at every witness") {
  const std::string tilted = seed_with("release-from-rest", "-alpha < theta_0 < 0"),
                    left = seed_with("critical-condition", "0 < theta_ex < alpha"),
                    turned = seed_with("height-of-centre", "theta < 0");
  CHECK(judged("release-from-rest", "-alpha + (alpha - abs(theta_0))*cosh(p*t)", tilted).outcome ==
        Outcome::correct);
  CHECK(judged("critical-condition", "abs(thetadot_ex) = p*(alpha - theta_ex)", left).outcome ==
        Outcome::correct);
  CHECK(judged("height-of-centre", "R*(cos(alpha - abs(theta)) - cos(alpha))", turned).outcome ==
        Outcome::correct);
  CHECK(prepared("misprint-in-17").symbols.find("theta")->range == "(0, pi/2)");
  int witnesses = 0;
  for (const std::string seed : {"", "1", "2", "3"})
    for (const Prepared& one : all_prepared(seed)) {
      const Exercise& exercise = one.exercise;
      if (exercise.given.empty() || exercise.example.empty()) continue;
      for (const std::string factor : {"", "1/3*", "exp(1/7)*"}) {
        const bool is_equation = exercise.kind == Kind::equation;
        const Opinion opinion = judge_answer(
            one, is_equation ? exercise.example + factor.substr(0, 0) + " + " + factor + exercise.pivot
                             : factor + "(" + exercise.example + ")");
        if (!opinion.witness) continue;
        ++witnesses;
        RoughPoint at;
        for (const auto& [name, value] : opinion.witness->at) at[name] = std::stod(value);
        for (const auto& text : exercise.given)
          for (const auto& link : links_of(parse_relation(text, exercise.language()))) {
            const auto names = names_of(link);
            if (!std::ranges::all_of(names, [&](const auto& name) { return at.contains(name); })) continue;
            CHECK_MESSAGE(holds({link}, at), exercise.id, ": ", text, " at ", place_of(*opinion.witness));
          }
      }
    }
  CHECK(witnesses > 3);
}

TEST_CASE("what was read, typed back, is judged the same") {
  int echoes = 0;
  for (const Prepared& one : all_prepared())
    for (const auto& answer : typed_answers(one)) {
      const Opinion opinion = judge_answer(one, answer);
      if (opinion.outcome == Outcome::invalid || opinion.outcome == Outcome::ambiguous) continue;
      REQUIRE_MESSAGE(!opinion.read_as.empty(), one.exercise.id, ": ", answer);
      const Opinion again = judge_answer(one, opinion.read_as);
      ++echoes;
      CHECK_MESSAGE(again.outcome == opinion.outcome, one.exercise.id, ": ", answer, " → ", opinion.read_as);
      CHECK_MESSAGE(again.note.word == opinion.note.word, one.exercise.id, ": ", answer, " → ",
                    opinion.read_as);
      CHECK_MESSAGE(again.read_as == opinion.read_as, one.exercise.id, ": ", answer);
    }
  CHECK(echoes > 500);
}

TEST_CASE("a right answer that is written otherwise is right, or one of its readings is") {
  int readings = 0;
  for (const Prepared& one : all_prepared())
    for (const auto& right : one.exercise.equivalents)
      for (const auto& typed : {std::regex_replace(right, std::regex(R"(\*(?![0-9]))"), " "),
                                std::regex_replace(right, std::regex(R"((sin|cos)\((\w+)\)\^2)"), "$1^2($2)"),
                                std::regex_replace(right, std::regex(R"((sin|cos)\((\w+)\))"), "$1 $2"),
                                std::regex_replace(right, std::regex(R"((\d)\.(\d))"), "$1,$2")}) {
        const Opinion opinion = judge_answer(one, typed);
        const bool is_right =
            opinion.outcome == Outcome::correct ||
            std::ranges::any_of(opinion.readings, [&](const std::string& text) {
              const Opinion again = judge_answer(one, text);
              CHECK_MESSAGE(again.outcome != Outcome::ambiguous, one.exercise.id, ": ", typed, " → ", text);
              ++readings;
              return again.outcome == Outcome::correct;
            });
        CHECK_MESSAGE(is_right, one.exercise.id, ": ", typed, " → ", to_string(opinion.outcome), ": ",
                      opinion.feedback);
      }
  CHECK(readings > 3);
}

TEST_CASE("no brace of a template, and no right answer, is in what a student is told") {
  std::size_t texts = 0;
  const auto check = [&](const Prepared& one, const std::string& text, bool may_be_right = false) {
    ++texts;
    CHECK_MESSAGE(text.find_first_of("{}") == std::string::npos, one.exercise.id, ": ", text);
    if (may_be_right || text.find('\n') != std::string::npos) return;
    for (const auto& span : spans(text)) {
      const bool is_formula = one.exercise.kind == Kind::expression || one.exercise.kind == Kind::equation;
      if (is_formula && span.kind == Span::Kind::math)
        CHECK_MESSAGE(judge_answer(one, span.text).outcome != Outcome::correct, one.exercise.id, ": ", text);
    }
  };
  for (int seed = 0; seed < 6; ++seed)
    for (const Prepared& one : all_prepared(seed == 0 ? "" : std::to_string(seed))) {
      const Exercise& exercise = one.exercise;
      check(one, presentation(exercise), true);
      check(one, solution_text(one), true);
      check(one, exercise.title);
      check(one, exercise.name, true);
      for (const auto& hint : exercise.hints) check(one, hint);
      for (const auto& option : exercise.options)
        for (const auto& text : {option.text, option.says, option.hint}) check(one, text, true);
      for (const auto& assumption : exercise.assumptions) check(one, assumption.says);
      for (const auto& slip : exercise.slips) {
        check(one, slip.says);
        check(one, slip.hint);
      }
      if (seed > 0) continue;
      for (const auto& answer : typed_answers(one)) {
        const Opinion opinion = judge_answer(one, answer);
        if (opinion.outcome == Outcome::invalid) continue;
        check(one, opinion.feedback);
        check(one, opinion.hint);
      }
    }
  CHECK(texts > 2000);
  const std::filesystem::path nowhere =
      std::filesystem::temp_directory_path() / "no-such-progress-of-exercises";
  for (const std::string seed : {"", "1", "2", "3", "4"}) {
    const Classroom room{rederive::rocking_block::course(), exercises(seed), nowhere};
    std::string page = page_of_exercises(room, {{"lesson-01", "One\n"}});
    page.erase(page.rfind("<script"));
    for (std::size_t at; (at = page.find("<style>")) != std::string::npos;)
      page.erase(at, page.find("</style>", at) - at);
    page = std::regex_replace(page, std::regex(" data-[a-z]+=\"[^\"]*\""), "");
    CHECK_MESSAGE(page.find_first_of("{}") == std::string::npos, page.substr(page.find_first_of("{}"), 200));
  }
}

TEST_CASE("a quantity is a number with a unit, or a sum with one unit for all or one for each") {
  each_case("quantities", [](const std::string& text, const std::string& value) {
    CHECK(parse_quantity(text).value == doctest::Approx(std::stod(value)));
  });
  each_case("no_quantities", [](const std::string& text, const std::string& word) {
    try {
      (void)parse_quantity(text);
      FAIL_CHECK("it was read");
    } catch (const SyntaxError& error) {
      CHECK(invalid(error, text).note.word == word);
    }
  });
  each_case("read_back", [](const std::string& text) {
    const Quantity once = parse_quantity(text), twice = parse_quantity(once.read_as);
    CHECK(twice.read_as == once.read_as);
    CHECK(twice.value == once.value);
    CHECK(twice.dimension == once.dimension);
    CHECK(twice.digits == once.digits);
  });
}
