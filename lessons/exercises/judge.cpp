#include <fmt/format.h>

#include <algorithm>
#include <derivations/decide/problem.hpp>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/prove.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/page/lesson.hpp>
#include <map>
#include <stdexcept>

namespace rederive::classroom {
namespace {

/// The option whose claim the engine or the ledger bears out.
std::size_t right_option(const Prepared& prepared) {
  const auto& exercise = prepared.exercise;
  std::vector<std::size_t> right;
  for (std::size_t i = 0; i < exercise.options.size(); ++i) {
    const std::string& claim = exercise.options[i].claim;
    bool holds = false;
    if (!exercise.answer.row.empty()) {
      holds = claim == to_string(judged(exercise.paper(), exercise.answer.row).proof.verdict);
    } else {
      const Proof proof = decide(parse_statement(claim, prepared.symbols), prepared.answer.relation,
                                 prepared.symbols, prepared.answer.given);
      holds = proof.verdict == Verdict::proved || proof.verdict == Verdict::proved_under;
    }
    if (holds) right.push_back(i + 1);
  }
  if (right.size() != 1)
    throw std::runtime_error(fmt::format("exactly one option must be right, but {} are", right.size()));
  return right.front();
}

/// Every symbol whose value the samples must give.
std::set<std::string> names_to_sample(const Prepared& prepared) {
  std::set<std::string> names =
      names_of(put_in(prepared.answer.relation, prepared.answer.given, prepared.symbols));
  for (const auto& name : prepared.exercise.symbols)
    for (const auto& used :
         names_of(put_in(parse(name, prepared.symbols), prepared.answer.given, prepared.symbols)))
      names.insert(used);
  return names;
}

/// Cuts the range of a symbol to what lies beyond a constant: theta > 0. False where the relation says
/// something else.
bool narrow(Symbols& symbols, const Relation& relation) {
  for (const bool is_first : {true, false}) {
    const Tree &name = relation.sides[is_first ? 0 : 1], &end = relation.sides[is_first ? 1 : 0];
    const std::string& sign = relation.operators[0];
    if (!is_symbol(name) || !names_of(end).empty() || sign == "=") continue;
    const bool is_lower = is_first == sign.starts_with('>');
    const std::string text = print(end), bracket = sign.ends_with('=') ? "[]" : "()";
    const std::string given = is_lower ? bracket[0] + text + ", inf)" : "(-inf, " + text + bracket[1];
    const std::string before = symbols.find(name->text)->range;
    const Interval old = parse_range(before), fresh = parse_range(given);
    const bool is_tighter = is_lower ? compare(fresh.low, old.low) > 0 : compare(fresh.high, old.high) < 0;
    const std::size_t comma = before.find(','), at = given.find(',');
    if (is_tighter)
      symbols.narrow(name->text, is_lower ? given.substr(0, at) + before.substr(comma)
                                          : before.substr(0, comma) + given.substr(at));
    return true;
  }
  return false;
}

/// What the exercise gives becomes ranges, or assumptions where they are about symbols of the answer.
void take_given(Prepared& prepared, const std::set<std::string>& at_hand) {
  for (const auto& text : prepared.exercise.given)
    for (const auto& link : links_of(parse_relation(text, prepared.symbols))) {
      const auto names = names_of(link);
      if (narrow(prepared.symbols, link)) continue;
      if (std::includes(at_hand.begin(), at_hand.end(), names.begin(), names.end()))
        prepared.assumed.push_back(put_in(link, prepared.answer.given, prepared.symbols));
    }
  if (contradict(prepared.assumed, prepared.symbols))
    throw std::runtime_error("the conditions in 'given' contradict each other");
}

/// From the answer, what answers are compared with.
void add_comparisons(Prepared& prepared) {
  const Exercise& exercise = prepared.exercise;
  if (exercise.kind != Kind::number) {
    prepared.points = sample_points(names_to_sample(prepared), 3, prepared.symbols, prepared.assumed);
    prepared.signature = signature(put_in(prepared.answer.relation, prepared.answer.given, prepared.symbols),
                                   exercise.pivot, prepared.points);
  }
  add_roads(prepared);
}

}  // namespace

Prepared prepare(const Exercise& exercise) {
  Prepared prepared;
  prepared.exercise = exercise;
  prepared.symbols = exercise.language();
  try {
    if (exercise.kind == Kind::wrong_term) {
      prepared.answer.relation = printed_with_slip(exercise.answer, exercise.paper());
      prepared.choice = wrong_term(prepared.answer.relation, exercise.answer.row, exercise.paper());
      take_given(prepared, {});
      return prepared;
    }
    if (exercise.answer.row.empty())
      prepared.answer = resolve(exercise.answer, exercise.kind, *exercise.course);
    std::set<std::string> at_hand = names_of(prepared.answer.relation);
    at_hand.insert(exercise.symbols.begin(), exercise.symbols.end());
    add_definitions(prepared.answer.given, at_hand, exercise.name, *exercise.course);
    take_given(prepared, at_hand);
    if (exercise.kind == Kind::choice) {
      prepared.choice = right_option(prepared);
      return prepared;
    }
    add_comparisons(prepared);
  } catch (const std::exception& error) {
    throw BadInput(fmt::format("{}: exercise {}: {}", exercise.place, exercise.id, error.what()));
  }
  return prepared;
}

Exercise as_exercise(const Exercise& whole, const Relation& before, const Relation& after) {
  Exercise step;
  step.course = whole.course;
  step.id = whole.id;
  step.seed = whole.seed;
  step.kind = before.operators.empty() ? Kind::expression : Kind::equation;
  std::set<std::string> first = names_of(before), names = names_of(after);
  if (whole.kind == Kind::equation && first.contains(whole.pivot) && names.contains(whole.pivot))
    step.pivot = whole.pivot;
  names.merge(first);
  step.symbols.assign(names.begin(), names.end());
  return step;
}

Prepared prepare_step(const Prepared& whole, const Relation& before, const Relation& after) {
  Prepared step;
  step.exercise = as_exercise(whole.exercise, before, after);
  step.symbols = whole.symbols;
  step.assumed = whole.assumed;
  step.answer.relation = before;
  step.answer.given = whole.answer.given;
  const auto& names = step.exercise.symbols;
  add_definitions(step.answer.given, {names.begin(), names.end()}, whole.exercise.name,
                  *whole.exercise.course);
  add_comparisons(step);
  return step;
}

Opinion judge_answer(const Prepared& prepared, const std::string& text) {
  if (text.find_first_not_of(" \t\r\n") == std::string::npos)
    return invalid("empty", "There is no answer here yet.");
  switch (prepared.exercise.kind) {
    case Kind::expression:
    case Kind::equation:
      return judge_formula(prepared, text);
    case Kind::number:
      return judge_number(prepared, text);
    default:
      return judge_choice(prepared, text);
  }
}

int exit_code(const Opinion& opinion) {
  if (opinion.verdict == "correct") return 0;
  if (opinion.verdict == "invalid") return 2;
  return opinion.verdict == "undecided" ? 3 : 1;
}

Opinion invalid(const std::string& note, const std::string& feedback) {
  return {"invalid", note, "", feedback, {}};
}

Opinion invalid(const SyntaxError& error, const std::string& text) {
  return invalid(error.note, explain(error, text));
}

std::string model_answer(const Prepared& prepared) {
  const auto& exercise = prepared.exercise;
  switch (exercise.kind) {
    case Kind::expression:
      return (exercise.name.empty() ? "" : exercise.name + " = ") +
             print(prepared.answer.relation.sides.at(0));
    case Kind::equation:
      return print(prepared.answer.relation);
    case Kind::number: {
      const std::string value = fmt::format("{:#.{}g}", prepared.answer.number, exercise.digits);
      return exercise.unit.empty() || exercise.unit == "1" ? value : value + " " + exercise.unit;
    }
    case Kind::wrong_term:
      return std::to_string(prepared.choice);
    case Kind::choice:
      return std::string(1, static_cast<char>('a' + prepared.choice - 1));
  }
  return "";
}

}  // namespace rederive::classroom
