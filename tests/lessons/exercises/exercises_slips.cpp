// What is said of wrong answers: of those that are one edit away from a right one, how many are named; and
// that nothing untrue is said.
#include <doctest/doctest.h>

#include <cstdio>
#include <derivations/paper/mutate.hpp>
#include <tests/block.hpp>
#include <tests/cases.hpp>

#include "classroom.hpp"

using namespace rederive::language;
using namespace rederive::paper;
using namespace rederive::classroom;
using namespace rederive::classroom;
using namespace rederive::test;

namespace {

/// The answers one edit away from the model answer and from each right answer in another form. A number is
/// spoilt in its formula and given to as many digits as are asked for.
std::vector<std::string> one_edit_away(const Prepared& one) {
  std::vector<std::string> result;
  const Exercise& exercise = one.exercise;
  if (exercise.kind == Kind::number) {
    if (one.answer.relation.sides.empty()) return result;
    RoughPoint at;
    for (const auto& [name, value] : one.answer.values) at[name] = rough_value(value, {});
    for (const auto& mutant : mutants(one.answer.relation)) {
      char text[40];
      std::snprintf(text, sizeof text, "%#.*g", exercise.digits, rough_value(mutant.relation.sides[0], at));
      result.push_back(text + (exercise.unit == "1" ? "" : " " + exercise.unit));
    }
    return result;
  }
  std::vector<std::string> right = exercise.equivalents;
  right.push_back(model_answer(one));
  for (const auto& text : right)
    for (const auto& mutant : mutants(parse_statement(text)))
      result.push_back(mutant.relation.operators.empty() ? print(mutant.relation.sides[0])
                                                         : print(mutant.relation));
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

TEST_CASE("of wrong answers one edit away at most one in twenty is unnamed") {
  int wrong = 0, unnamed = 0;
  const bool verbose = std::getenv("REDERIVE_SAY_UNNAMED") != nullptr;
  for (const auto& exercise : exercises()) {
    if (exercise.kind == Kind::choice || exercise.kind == Kind::wrong_term) continue;
    for (const auto& answer : one_edit_away(prepared(exercise.id))) {
      const Opinion opinion = judge_answer(prepared(exercise.id), answer);
      if (opinion.outcome == Outcome::correct || opinion.outcome == Outcome::wrong_form ||
          opinion.outcome == Outcome::invalid)
        continue;
      ++wrong;
      const bool named = opinion.note.word != "other" && opinion.note.word != "undecided" &&
                         opinion.note.word != "not_everywhere";
      unnamed += !named;
      if (verbose)
        std::printf("%s  %-28s %-16s %s | %s\n", named ? " " : "?", exercise.id.c_str(),
                    opinion.note.word.c_str(), answer.c_str(), opinion.feedback.c_str());
    }
  }
  std::printf("Of %d wrong answers one edit away %d are unnamed: %.1f %%\n", wrong, unnamed,
              100.0 * unnamed / wrong);
  CHECK(wrong > 500);
  CHECK(20 * unnamed <= wrong);
}

TEST_CASE("answers get their notes and verdicts, and are told what is true of them") {
  for (const char* section :
       {"right_in_any_form", "typed", "slips", "nothing_untrue", "right_where_it_is_set", "digits_and_terms",
        "dropped_or_exchanged", "behind_a_name"})
    each_case(section, [](const std::string& id, const std::string& answer, const std::string& word,
                          const std::string& verdict) {
      const Opinion opinion = judged(id, answer);
      CHECK(opinion.note.word == word);
      if (!verdict.empty()) CHECK(to_string(opinion.outcome) == verdict);
    });
  using Text = std::string;
  each_case("not_called_so",
            [](const Text& id, const Text& answer, const Text& word) { CHECK(note(id, answer) != word); });
  each_case("says_at_the_end", [](const Text& id, const Text& answer, const Text& text) {
    CHECK(said(id, answer).ends_with(text));
  });
  each_case("says", [](const Text& id, const Text& answer, const Text& text) {
    CHECK(contains(said(id, answer), text));
  });
  each_case("does_not_say", [](const Text& id, const Text& answer, const Text& text) {
    CHECK_FALSE(contains(said(id, answer), text));
  });
}

TEST_CASE("a point to try by hand comes with an answer that no part of it repairs") {
  CHECK(
      judged("linear-equation", "thetaddot - p^2*theta = -p^2*alpha - p^2*a_p/g*(omega_p*t + psi)").witness);
  CHECK(judged("restitution", "sqrt((1-3/2*sin(alpha)^2)^2)").witness);
  CHECK(!judged("critical-condition", "thetadot_ex^2 = p^2*(theta_ex + alpha)^2").witness);
  CHECK_FALSE(contains(judged("restitution", "1 - 3/2*sin(alpha)").hint, "unit"));
}

TEST_CASE("the last line of every solution is judged right, and numbers are put in") {
  for (const auto& exercise : exercises()) {
    CAPTURE(exercise.id);
    const Prepared& one = prepared(exercise.id);
    std::string text = solution_text(one);
    REQUIRE(text.ends_with('\n'));
    text.pop_back();
    const Opinion opinion = judge_answer(one, text.substr(text.rfind('\n') + 1));
    CHECK_MESSAGE(opinion.outcome == Outcome::correct, text.substr(text.rfind('\n') + 1));
    if (exercise.kind == Kind::number && exercise.answer.function.empty())
      CHECK(contains(text, "With the numbers"));
  }
}

TEST_CASE("a point to try by hand is one of a piece of furniture") {
  for (const Prepared& one : all_prepared()) {
    if (one.exercise.example.empty() || !one.exercise.asks_for_formula()) continue;
    const Opinion opinion = judge_answer(one, one.exercise.example);
    if (!opinion.witness) continue;
    std::map<std::string, double> at;
    for (const auto& [name, value] : opinion.witness->at) at[name] = std::stod(value);
    CAPTURE(one.exercise.id);
    if (!at.contains("alpha")) continue;
    CHECK(at["alpha"] <= 0.5);
    for (const char* angle : {"theta", "theta_0", "theta_ex", "theta_i"})
      if (at.contains(angle)) CHECK(std::abs(at[angle]) < at["alpha"]);
    if (at.contains("R")) CHECK(at["R"] <= 2);
  }
}

TEST_CASE("a point to try by hand has numbers of one or two digits, and results of six") {
  const Opinion opinion = judged("height-of-centre", "R*(cos(alpha - theta/2)^3 - cos(alpha))");
  REQUIRE(opinion.witness);
  for (const auto& [name, value] : opinion.witness->at)
    CHECK(std::count_if(value.begin(), value.end(), [](char c) { return c >= '1' && c <= '9'; }) <= 2);
  CHECK(opinion.witness->printed.size() <= 10);  // such as 0.00123456
  CHECK(opinion.witness->printed != opinion.witness->derived);
}
