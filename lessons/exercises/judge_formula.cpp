#include <fmt/format.h>

#include <algorithm>
#include <lessons/exercises/judge_formula.hpp>
#include <lessons/exercises/units.hpp>
#include <lessons/exercises/why_wrong.hpp>
#include <lessons/page/prose.hpp>

namespace rederive::classroom {
using namespace language;
using namespace decide;
using namespace paper;
using namespace page;
namespace {

/// Returns the byte at which the text of a tree has the symbol.
std::optional<std::size_t> position_of(const Tree& tree, const std::string& name) {
  if (tree->kind == Node::Kind::symbol && tree->text == name) return tree->position;
  for (const auto& child : tree->children)
    if (const auto found = position_of(child, name)) return found;
  return {};
}

bool may_use(const Exercise& exercise, const std::string& name) {
  return std::ranges::find(exercise.symbols, name) != exercise.symbols.end();
}

/// Refuses symbols that the exercise does not give, at their places.
void check_symbols(const Exercise& exercise, const Relation& read) {
  for (const auto& name : names_of(read)) {
    if (may_use(exercise, name)) continue;
    for (const auto& side : read.sides)
      if (const auto position = position_of(side, name))
        throw SyntaxError(Mistake::symbol_not_given, *position,
                          fmt::format("'{}' is not among the symbols of this exercise: {}{}", name,
                                      fmt::join(exercise.symbols, ", "),
                                      name == "e" ? "; the exponential function is exp(x)" : ""));
  }
}

/// Refuses "4/3*m*R^2 kg*m^2": a unit after a formula whose symbols already have theirs.
void refuse_unit(const Exercise& exercise, const std::string& text) {
  const std::size_t blank = text.find_last_of(' ');
  if (blank == std::string::npos || !is_unit(text.substr(blank + 1))) return;
  try {
    (void)parse_statement(text.substr(0, blank), exercise.language());
    const auto names = names_of(parse(text.substr(blank + 1), exercise.language()));
    if (!names.empty() && may_use(exercise, *names.begin())) return;
  } catch (const SyntaxError& error) {
    if (error.mistake != Mistake::unknown_symbol) return;
  }
  throw SyntaxError(Mistake::unit_not_wanted, blank + 1,
                    "write no unit here: the symbols have their units already");
}

/// Returns the expression that was typed, alone or after its name.
Relation expression_in(const Exercise& exercise, const Relation& read, bool is_named) {
  if (is_named) {
    check_relation(exercise, read.operators[0]);
    return {{read.sides[1]}, {}};
  }
  if (!read.operators.empty())
    throw SyntaxError(
        Mistake::expression_wanted, 0,
        "an expression is expected here, " +
            (exercise.name.empty() ? "without a relation sign" : "alone or after " + exercise.name + " ="));
  return read;
}

/// Returns the equation that was typed, or of which the right side was typed.
Relation equation_in(const Exercise& exercise, const Relation& read, std::size_t size) {
  if (read.operators.empty() && !exercise.name.empty())
    return {{parse(exercise.name, exercise.language()), read.sides[0]}, {"="}};
  if (read.operators.empty())
    throw SyntaxError(Mistake::equation_wanted, size, "an equation is expected here: left side = right side");
  if (read.operators.size() > 1)
    throw SyntaxError(Mistake::one_relation_wanted, 0, "one relation is expected here, not a chain");
  if (read.operators[0] != "=")
    throw SyntaxError(Mistake::equation_wanted, 0, "an equation is expected here, with =, not an inequality");
  return read;
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
        Mistake::value_wanted, 0,
        fmt::format("'{}' is not what is asked for: write {} = and a value", relation, exercise.name));
}

reader::Readings readings_of(const Exercise& exercise, const std::string& text) {
  return reader::generous_readings(text, {.symbols = exercise.language(), .given = exercise.symbols});
}

reader::Readings read_answer(const Exercise& exercise, const std::string& text) {
  refuse_unit(exercise, text);
  reader::Readings readings = readings_of(exercise, text);
  const bool is_equation = exercise.kind == Kind::equation;
  for (Relation& read : readings.all) {
    const bool is_named = read.sides.size() == 2 && is_asked_for(exercise, read.sides[0]);
    const Relation meant =
        is_equation ? equation_in(exercise, read, text.size()) : expression_in(exercise, read, is_named);
    Relation checked = meant;
    if (is_equation && is_named) checked.sides.erase(checked.sides.begin());
    check_symbols(exercise, checked);
    read = meant;
  }
  return readings;
}

Opinion judge_formula(const Prepared& prepared, const std::string& text) {
  try {
    const reader::Readings readings = read_answer(prepared.exercise, text);
    std::vector<Opinion> opinions;
    for (const Relation& read : readings.all) opinions.push_back(judge_formula(prepared, read));
    return opinion_on_all(opinions, readings.reason);
  } catch (const SyntaxError& error) {
    return invalid(error, text);
  }
}

Opinion judge_formula(const Prepared& prepared, const Relation& read) {
  for (const auto& side : read.sides)
    lower(side, prepared.symbols);  // refuses what is undefined, such as 1/0
  const auto mine = signature_of(prepared, read);
  const bool surely_different = mine && prepared.signature && !alike(*mine, *prepared.signature) &&
                                (read.operators.empty() || !prepared.exercise.pivot.empty());
  const Proof proof = proof_of(prepared, read, prepared.answer.relation);
  const bool has_value = read.operators.empty() || !prepared.sieve || prepared.sieve->is_empty() ||
                         prepared.sieve->has_value(read);  // log(x) = 1 does not say that x = -1
  Opinion opinion;
  if (is_right(proof.verdict) && !has_value)
    opinion = undecided("where the right equation holds, yours has no value.");
  else if (is_right(proof.verdict))
    opinion = right_answer();
  else if (proof.verdict == Verdict::undecided && !surely_different)
    opinion = undecided(proof.reason);
  else
    opinion = why_wrong(prepared, read, mine);
  opinion.read_as = as_typed(print_statement(read, Notation::plain, {}));
  return opinion;
}

}  // namespace rederive::classroom
