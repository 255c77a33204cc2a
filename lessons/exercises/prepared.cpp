#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <derivations/decide/problem.hpp>
#include <derivations/numbers/interval.hpp>
#include <derivations/paper/mutate.hpp>
#include <derivations/program/program.hpp>
#include <functional>
#include <lessons/exercises/prepared.hpp>
#include <lessons/exercises/terms.hpp>
#include <lessons/exercises/units.hpp>
#include <map>
#include <numbers>
#include <stdexcept>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace program;
using namespace paper;
using namespace page;
namespace {

/// Returns the option whose claim the engine or the ledger confirms.
std::size_t right_option(const Prepared& prepared) {
  const auto& exercise = prepared.exercise;
  std::vector<std::size_t> right;
  for (std::size_t i = 0; i < exercise.options.size(); ++i) {
    const std::string& claim = exercise.options[i].claim;
    bool holds = false;
    if (!exercise.answer.row.empty()) {
      holds = claim == to_string(judged(exercise.paper(), exercise.answer.row).proof.verdict);
    } else {
      holds = is_right(decide::decide(parse_statement(claim, prepared.symbols), prepared.answer.relation,
                                      prepared.symbols, prepared.answer.given)
                           .verdict);
    }
    if (holds) right.push_back(i + 1);
  }
  if (right.size() != 1)
    throw std::runtime_error(fmt::format("exactly one option must be right, but {} are", right.size()));
  return right.front();
}

/// Returns every symbol that must have a value at the samples.
std::set<std::string> names_to_sample(const Prepared& prepared) {
  std::set<std::string> names =
      names_of(put_in(prepared.answer.relation, prepared.answer.given, prepared.symbols));
  for (const auto& name : prepared.exercise.symbols)
    for (const auto& used :
         names_of(put_in(parse(name, prepared.symbols), prepared.answer.given, prepared.symbols)))
      names.insert(used);
  return names;
}

/// Narrows the range of a symbol to what lies beyond a constant: theta > 0. Returns false if the relation
/// says something else, or more than a range does, whose end at sqrt(2) is a rational number further out.
bool narrow(Symbols& symbols, const Relation& relation) {
  for (const bool is_first : {true, false}) {
    const Tree &name = relation.sides[is_first ? 0 : 1], &end = relation.sides[is_first ? 1 : 0];
    const std::string& sign = relation.operators[0];
    if (!is_symbol(name) || !names_of(end).empty() || sign == "=") continue;
    const bool is_lower = is_first == sign.starts_with('>');
    Range range = read_range(symbols.find(name->text)->range);
    (is_lower ? range.lower : range.upper) = print(end);
    (is_lower ? range.lower_closed : range.upper_closed) = sign.ends_with('=');
    Symbols narrowed = symbols;
    narrowed.narrow(name->text, range);
    const Interval old = parse_range(symbols.find(name->text)->range),
                   given = parse_range(narrowed.find(name->text)->range);
    if (is_lower ? compare(given.low, old.low) > 0 : compare(given.high, old.high) < 0)
      symbols = std::move(narrowed);
    return value_at(end, {}, 64).constant.has_value();
  }
  return false;
}

/// Turns what the exercise gives into ranges, or into assumptions about symbols of the answer.
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

Opinion listed(const ListedSlip& slip) {
  Opinion opinion = wrong_answer(slip.note, slip.says);
  opinion.hint = slip.hint;
  return opinion;
}

/// Adds the wrong formulas that the exercise lists, and the right one under its assumptions.
void add_formulas(Prepared& prepared) {
  const Exercise& exercise = prepared.exercise;
  const auto add = [&](const Relation& relation, const Opinion& opinion) {
    prepared.roads.push_back(
        {.opinion = opinion, .relation = relation, .signature = signature_of(prepared, relation)});
  };
  for (const auto& slip : exercise.slips)
    add(slip.road ? resolve(*slip.road, exercise.kind, *exercise.course).relation
                  : parse_statement(slip.typed, prepared.symbols),
        listed(slip));
  for (const auto& assumption : exercise.assumptions) {
    Relation relation = prepared.answer.relation;
    for (const auto& [name, value] : assumption.put)
      relation = decide::put_in(relation, name, parse(value, prepared.symbols));
    add(relation, half_right(wrong_answer(Slip::assumption, assumption.says)));
  }
}

/// Adds the wrong numbers that the exercise lists.
void add_listed_numbers(Prepared& prepared) {
  const Exercise& exercise = prepared.exercise;
  for (const auto& slip : exercise.slips)
    prepared.roads.push_back({.opinion = listed(slip),
                              .number = slip.road
                                            ? resolve(*slip.road, exercise.kind, *exercise.course).number
                                            : parse_quantity(slip.typed).value,
                              .digits = slip.digits});
}

/// Returns the slip of a pen that a mutant of a formula shows.
Slip slip_of(const Mutant& mutant) {
  static const std::map<Edit, Slip> slips{
      {Edit::sign, Slip::sign},         {Edit::coefficient, Slip::factor},
      {Edit::function, Slip::sin_cos},  {Edit::symbol, Slip::wrong_symbol},
      {Edit::square, Slip::power},      {Edit::factor, Slip::missing_factor},
      {Edit::term, Slip::missing_term}, {Edit::dot, Slip::missing_dot}};
  return slips.at(mutant.slip);
}

/// Calls take(wrong formula, slip) for each part of a formula that is squared, upside down, halved or raised
/// by one, and for each function that is left out.
void for_each_changed_part(const Tree& node, const std::function<void(const Tree&, Slip)>& take) {
  if (node->kind == Node::Kind::number) {
    take(product(node, number("10")), Slip::power_of_ten);
    take(sum(node, number("1"), true), Slip::factor);
  } else {
    take(product(node, node), Slip::power);
    take(product(number("1"), node, true), Slip::reciprocal);
    take(sum(node, number("1")), Slip::extra_term);
  }
  take(product(node, number("2"), true), Slip::factor);
  if (node->kind == Node::Kind::call && node->children.size() == 1)
    take(node->children[0], Slip::wrong_function);
  for (std::size_t k = 0; k < node->children.size(); ++k)
    for_each_changed_part(node->children[k],
                          [&](const Tree& child, Slip slip) { take(with_child(node, k, child), slip); });
}

/// Calls take(wrong formula, slip) for each slip of a pen in a formula for a number.
template <class Take>
void for_each_slip(const Tree& formula, const Paper& paper, const Take& take) {
  for (const auto& mutant : mutants({{formula}, {}}, paper)) {
    const Slip slip = slip_of(mutant);
    take(mutant.relation.sides[0], slip);
    if (slip == Slip::missing_term)
      take(negative(mutant.relation.sides[0]), Slip::taken_away);  // x for 1 - x
  }
  for (const auto& [first, last] : runs_of(formula))
    take(with_flipped(formula, first, last), Slip::reciprocal);
  for_each_changed_part(formula, take);
  take(language::put_in(formula, "pi", number("180")), Slip::degrees);
}

/// Adds what comes of a number by the slips of a pen in its formula, or in the values that are put into it.
void add_slips_in_formula(Prepared& prepared) {
  if (prepared.answer.relation.sides.empty()) return;
  const Tree& formula = prepared.answer.relation.sides[0];
  const Paper& paper = prepared.exercise.paper();
  const double right = prepared.answer.number;
  const auto add = [&](const Tree& wrong, const RoughPoint& at, Slip slip) {
    const double value = rough_value(wrong, at);
    if (std::isfinite(value) && !(std::abs(value - right) <= allowance(right, prepared.exercise.digits)))
      prepared.roads.push_back({.opinion = wrong_number(slip), .number = value});
  };
  RoughPoint at;
  for (const auto& [name, value] : prepared.answer.values) at[name] = rough_value(value, {});
  for_each_slip(formula, paper, [&](const Tree& wrong, Slip slip) { add(wrong, at, slip); });
  for (const auto& [name, value] : prepared.answer.values) {
    const auto add_with = [&, &name = name](double instead, Slip slip) {
      RoughPoint other = at;
      other[name] = instead;
      add(formula, other, slip);
    };
    constexpr double degree = std::numbers::pi / 180;
    for (const double factor : {2.0, 0.5}) add_with(at[name] * factor, Slip::factor);
    for (const double factor : {degree, 1 / degree}) add_with(at[name] * factor, Slip::degrees);
    for_each_slip(value, paper,
                  [&](const Tree& wrong, Slip slip) { add_with(rough_value(wrong, {}), slip); });
  }
}

/// Computes what answers are compared with.
void add_comparisons(Prepared& prepared) {
  const Exercise& exercise = prepared.exercise;
  if (exercise.kind == Kind::number) {
    add_listed_numbers(prepared);
    add_slips_in_formula(prepared);
    return;
  }
  prepared.points = sample_points(names_to_sample(prepared), 3, prepared.symbols, prepared.assumed);
  prepared.signature = signature_of(prepared, prepared.answer.relation);
  prepared.sieve.emplace(prepared.answer.relation, prepared.answer.given, exercise.pivot, prepared.symbols,
                         prepared.assumed);
  add_formulas(prepared);
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

Exercise step_of(const Exercise& whole, const Relation& before, const Relation& after) {
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
  step.exercise = step_of(whole.exercise, before, after);
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

bool is_right(Verdict verdict) { return verdict == Verdict::proved || verdict == Verdict::proved_under; }

std::optional<Signature> signature_of(const Prepared& prepared, const Relation& statement) {
  return signature(put_in(statement, prepared.answer.given, prepared.symbols), prepared.exercise.pivot,
                   prepared.points);
}

Proof proof_of(const Prepared& prepared, const Relation& read, const Relation& against) {
  return decide::decide(read, against, prepared.symbols, prepared.answer.given, prepared.assumed);
}

double allowance(double right, int digits) {
  if (right == 0) return 0;
  return 0.5000001 * std::pow(10.0, std::floor(std::log10(std::abs(right))) - digits + 1);
}

Opinion wrong_number(const Note& note) {
  const std::string words = slip_words(SlipTable::number, note);
  return wrong_answer(note, words.empty() ? slip_words(SlipTable::answer, note) : words);
}

}  // namespace rederive::classroom
