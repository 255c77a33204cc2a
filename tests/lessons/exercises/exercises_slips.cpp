// What is said of wrong answers: of those that are one edit away from a right one, how many are named; and
// that nothing untrue is said.
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <derivations/paper/mutate.hpp>
#include <functional>
#include <lessons/exercises/said.hpp>
#include <tests/block.hpp>
#include <tests/cases.hpp>

#include "classroom.hpp"

using namespace rederive::language;
using namespace rederive::paper;
using namespace rederive::classroom;
using namespace rederive::classroom;
using namespace rederive::test;

namespace {

using Take = std::function<void(const Tree&)>;

/// Calls take for each change of one part that mutants() does not make: another symbol, a power, a quotient
/// upside down, another number, a function lost, a factor or a term too many.
void each_other_edit(const Tree& node, const std::vector<std::string>& names, const Take& take) {
  namespace to = edits;
  const Tree square = make_tree(Node::Kind::power, "", {node, to::number("2")});
  if (node->kind == Node::Kind::symbol)
    for (const auto& name : names)
      if (name != node->text) take(to::symbol(name));
  if (node->kind == Node::Kind::symbol || node->kind == Node::Kind::call || node->kind == Node::Kind::sum) {
    take(square);
    take(to::product(to::number("1"), node, true));
    take(to::product(node, to::number("2"), true));
    take(to::call("abs", node));
    take(to::sum(node, to::number("1")));
    if (!names.empty()) take(to::product(node, to::symbol(names.front())));
  }
  if (node->kind == Node::Kind::number) {
    take(to::product(node, to::number("2"), true));
    take(to::product(node, to::number("10")));
    take(to::sum(node, to::number("1"), true));
  }
  if (node->kind == Node::Kind::call && node->children.size() == 1) take(node->children[0]);
  for (const auto& [first, last] : to::runs_of(node)) take(to::with_flipped(node, first, last));
  for (std::size_t k = 0; k < node->children.size(); ++k)
    each_other_edit(node->children[k], names,
                    [&](const Tree& child) { take(to::with_child(node, k, child)); });
}

/// A relation with each single edit; of the other kinds, 40 at most, evenly among all that there are.
std::vector<Relation> edited(const Relation& right, const std::vector<std::string>& names) {
  std::vector<Relation> all, others;
  for (const auto& mutant : mutants(right)) all.push_back(mutant.relation);
  for (std::size_t side = 0; side < right.sides.size(); ++side)
    each_other_edit(right.sides[side], names, [&](const Tree& tree) {
      others.push_back(right);
      others.back().sides[side] = tree;
    });
  const std::size_t step = others.size() / 40 + 1;
  for (std::size_t k = 0; k < others.size(); k += step) all.push_back(others[k]);
  return all;
}

/// The numbers one edit away: of the formula, of a value that is put into it, and of the result.
std::vector<double> numbers_one_edit_away(const Prepared& one) {
  const double right = one.answer.number;
  std::vector<double> all{-right, 2 * right, right / 2, 10 * right, right / 1000, right * right, 1 / right};
  if (right > 0) all.push_back(std::sqrt(right));
  if (one.answer.relation.sides.empty()) return all;
  RoughPoint at;
  for (const auto& [name, value] : one.answer.values) at[name] = rough_value(value, {});
  for (const auto& wrong : edited(one.answer.relation, {})) all.push_back(rough_value(wrong.sides[0], at));
  for (const auto& [name, value] : one.answer.values)
    for (const auto& wrong : edited({{value}, {}}, {})) {
      RoughPoint other = at;
      other[name] = rough_value(wrong.sides[0], {});
      all.push_back(rough_value(one.answer.relation.sides[0], other));
    }
  return all;
}

/// The answers one edit away from the model answer and from each right answer in another form. A number has
/// as many digits as are asked for.
std::vector<std::string> one_edit_away(const Prepared& one) {
  std::vector<std::string> result;
  const Exercise& exercise = one.exercise;
  if (exercise.kind == Kind::number) {
    for (const double value : numbers_one_edit_away(one)) {
      char text[40];
      std::snprintf(text, sizeof text, "%#.*g", exercise.digits, value);
      if (std::isfinite(value)) result.push_back(text + (exercise.unit == "1" ? "" : " " + exercise.unit));
    }
  } else {
    std::vector<std::string> right = exercise.equivalents;
    right.push_back(model_answer(one));
    for (const auto& text : right)
      for (const auto& wrong : edited(parse_statement(text), exercise.symbols))
        result.push_back(as_typed(wrong.operators.empty() ? print(wrong.sides[0]) : print(wrong)));
  }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

TEST_CASE(
    "of wrong answers one edit away at most one in twenty is unnamed, and no word gives the right one") {
  int formulas = 0, numbers = 0, unnamed_formulas = 0, unnamed_numbers = 0;
  const bool verbose = std::getenv("REDERIVE_SAY_UNNAMED") != nullptr;
  for (const auto& exercise : exercises()) {
    if (exercise.kind == Kind::choice || exercise.kind == Kind::wrong_term) continue;
    const Prepared& one = prepared(exercise.id);
    for (const auto& answer : one_edit_away(one)) {
      const Opinion opinion = judge_answer(one, answer);
      if (exit_code(opinion) == 0 || exit_code(opinion) == 2) continue;
      for (const std::string& text : {opinion.feedback, opinion.hint}) {
        CHECK_MESSAGE(answer_in(one, text) == "", exercise.id, ": ", answer, ": ", text);
        CHECK_MESSAGE(untrue(one, answer, text) == "", exercise.id, ": ", answer, ": ", text);
      }
      const bool named = opinion.note.word != "other" && opinion.note.word != "undecided" &&
                         opinion.note.word != "not_everywhere";
      const bool is_number = exercise.kind == Kind::number;
      ++(is_number ? numbers : formulas);
      (is_number ? unnamed_numbers : unnamed_formulas) += !named;
      if (verbose)
        std::printf("%s  %-28s %-16s %s | %s\n", named ? " " : "?", exercise.id.c_str(),
                    opinion.note.word.c_str(), answer.c_str(), opinion.feedback.c_str());
    }
  }
  std::printf("One edit away: %d of %d formulas and %d of %d numbers are unnamed\n", unnamed_formulas,
              formulas, unnamed_numbers, numbers);
  CHECK(formulas > 1500);
  CHECK(numbers > 300);
  CHECK(20 * unnamed_formulas <= formulas);
  CHECK(20 * unnamed_numbers <= numbers);
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
