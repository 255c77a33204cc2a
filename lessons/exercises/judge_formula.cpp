// Expressions and equations: right by proof, wrong by the first wrong road that leads to the same formula.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/trees.hpp>
#include <lessons/exercises/units.hpp>
#include <regex>

namespace rederive::classroom {
namespace {

const Node* find_symbol(const Tree& tree, const std::string& name) {
  if (tree->kind == Node::Kind::symbol && tree->text == name) return tree.get();
  for (const auto& child : tree->children)
    if (const Node* found = find_symbol(child, name)) return found;
  return nullptr;
}

/// Refuses symbols that the exercise does not give, where they stand.
void check_symbols(const Exercise& exercise, const Relation& read) {
  for (const auto& name : names_of(read)) {
    const auto& names = exercise.symbols;
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    for (const auto& side : read.sides)
      if (const Node* node = find_symbol(side, name))
        throw SyntaxError("symbol_not_given", node->position,
                          fmt::format("'{}' is not among the symbols of this exercise: {}{}", name,
                                      fmt::join(exercise.symbols, ", "),
                                      name == "e" ? "; the exponential function is exp(x)" : ""));
  }
}

/// "4/3*m*R^2 kg*m^2": a unit behind a formula whose symbols have theirs already.
void refuse_unit(const Exercise& exercise, const std::string& text) {
  const std::size_t blank = text.find_last_of(' ');
  if (blank == std::string::npos || !is_unit(text.substr(blank + 1))) return;
  try {
    (void)parse_statement(text.substr(0, blank), exercise.language());
    for (const auto& name : names_of(parse(text.substr(blank + 1), exercise.language())))
      if (std::find(exercise.symbols.begin(), exercise.symbols.end(), name) == exercise.symbols.end())
        break;
      else
        return;
  } catch (const SyntaxError& error) {
    if (error.note != "unknown_symbol") return;
  }
  throw SyntaxError("unit_not_wanted", blank + 1, "write no unit here: the symbols have their units already");
}

}  // namespace

bool is_asked_for(const Exercise& exercise, const Tree& left) {
  if (exercise.name.empty()) return false;
  const Symbols& symbols = exercise.language();
  return lower(left, symbols).is_equal(lower(parse(exercise.name, symbols), symbols));
}

void check_relation(const Exercise& exercise, const std::string& relation) {
  if (relation != "=" && (exercise.bound.empty() || !exercise.bound.starts_with(relation)))
    throw SyntaxError(
        "value_wanted", 0,
        fmt::format("'{}' is not what is asked for: write {} = and a value", relation, exercise.name));
}

Relation read_answer(const Exercise& exercise, const std::string& text) {
  refuse_unit(exercise, text);
  Relation read = parse_statement(text, exercise.language());
  const bool named = read.sides.size() == 2 && is_asked_for(exercise, read.sides[0]);
  if (exercise.kind == Kind::expression) {
    if (named) check_relation(exercise, read.operators[0]), read = {{read.sides[1]}, {}};
    if (!read.operators.empty())
      throw SyntaxError(
          "expression_wanted", 0,
          "an expression is expected here, " +
              (exercise.name.empty() ? "without a relation sign" : "alone or after " + exercise.name + " ="));
  } else {
    if (read.operators.empty() && !exercise.name.empty())
      read = {{parse(exercise.name, exercise.language()), read.sides[0]}, {"="}};
    if (read.operators.empty())
      throw SyntaxError("equation_wanted", text.size(),
                        "an equation is expected here: left side = right side");
    if (read.operators.size() > 1)
      throw SyntaxError("one_relation_wanted", 0, "one relation is expected here, not a chain");
    if (read.operators[0] != "=")
      throw SyntaxError("equation_wanted", 0, "an equation is expected here, with =, not an inequality");
  }
  Relation checked = read;
  if (exercise.kind == Kind::equation && named) checked.sides.erase(checked.sides.begin());
  check_symbols(exercise, checked);
  return read;
}

namespace {

std::optional<Signature> signature_of(const Prepared& prepared, const Relation& read) {
  return signature(put_in(read, prepared.answer.given, prepared.symbols), prepared.exercise.pivot,
                   prepared.points);
}

Road road_to(const Prepared& prepared, const Relation& relation, const std::string& note,
             const std::string& says, const std::string& verdict = "wrong") {
  return {note, says, verdict, relation, signature_of(prepared, relation), 0};
}

}  // namespace

std::string as_typed(const std::string& printed) {
  static const std::regex in_c("fabs\\(");
  return std::regex_replace(printed, in_c, "abs(");
}

bool is_right(Verdict verdict) { return verdict == Verdict::proved || verdict == Verdict::proved_under; }

Proof proof_of(const Prepared& prepared, const Relation& read, const Relation& against) {
  return decide(read, against, prepared.symbols, prepared.answer.given, prepared.assumed);
}

Opinion found(Opinion opinion, const std::string& verdict, const std::string& note, const std::string& says,
              double score) {
  opinion.verdict = verdict;
  opinion.note = note;
  opinion.feedback = says;
  opinion.score = score;
  return opinion;
}

void add_roads(Prepared& prepared) {
  const Exercise& exercise = prepared.exercise;
  if (exercise.kind != Kind::number)
    prepared.sieve.emplace(prepared.answer.relation, prepared.answer.given, exercise.pivot, prepared.symbols,
                           prepared.assumed);
  for (const auto& slip : exercise.slips) {
    if (exercise.kind == Kind::number) {
      Road road{.note = slip.note, .says = slip.says, .verdict = "wrong", .digits = slip.digits};
      road.number = slip.road ? resolve(*slip.road, exercise.kind, *exercise.course).number
                              : parse_quantity(slip.typed).value;
      prepared.roads.push_back(road);
      continue;
    }
    const Relation relation = slip.road ? resolve(*slip.road, exercise.kind, *exercise.course).relation
                                        : parse_statement(slip.typed, prepared.symbols);
    prepared.roads.push_back(road_to(prepared, relation, slip.note, slip.says));
  }
  if (exercise.kind == Kind::number) return add_roads_of_number(prepared);
  for (const auto& assumption : exercise.assumptions) {
    Relation relation = prepared.answer.relation;
    for (const auto& [name, value] : assumption.put)
      relation = rederive::put_in(relation, name, parse(value, prepared.symbols));
    prepared.roads.push_back(road_to(prepared, relation, "assumption", assumption.says, "correct_if"));
  }
}

Opinion judge_formula(const Prepared& prepared, const std::string& text) {
  try {
    return judge_formula(prepared, read_answer(prepared.exercise, text));
  } catch (const SyntaxError& error) {
    return invalid(error, text);
  }
}

Opinion judge_formula(const Prepared& prepared, const Relation& read) {
  Opinion opinion;
  opinion.read_as = as_typed(read.operators.empty() ? print(read.sides[0]) : print(read));
  for (const auto& side : read.sides)
    lower(side, prepared.symbols);  // refuses what is undefined at once, such as 1/0
  const auto mine = signature_of(prepared, read);
  const bool surely_different = mine && prepared.signature && !alike(*mine, *prepared.signature) &&
                                (read.operators.empty() || !prepared.exercise.pivot.empty());
  const Proof proof = proof_of(prepared, read, prepared.answer.relation);
  if (is_right(proof.verdict)) return found(opinion, "correct", "correct", "Right.", 1);
  if (proof.verdict == Verdict::undecided && !surely_different)
    return found(opinion, "undecided", "undecided", "This could not be decided: " + proof.reason, 0);
  return why_wrong(prepared, read, mine, opinion);
}

}  // namespace rederive::classroom
