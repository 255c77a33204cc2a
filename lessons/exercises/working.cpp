#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <derivations/program/program.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/judge_formula.hpp>
#include <lessons/exercises/units.hpp>
#include <lessons/exercises/why_wrong.hpp>
#include <lessons/exercises/working.hpp>
#include <lessons/page/prose.hpp>

namespace rederive::classroom {
using namespace language;
using namespace numbers;
using namespace decide;
using namespace mechanics;
using namespace program;
using namespace paper;
using namespace page;
namespace {

/// A step: one link of a line.
struct Step {
  int line = 0;
  std::string text;
  Relation says;                   ///< an equation, or an expression
  std::vector<Relation> assumed;   ///< for this step
  std::vector<std::string> small;  ///< symbols, to first order in which it is to hold

  bool is_under_assumptions() const { return !assumed.empty() || !small.empty(); }
};

/// Reads what is in brackets into the step, each part at its place, and returns the line without it.
std::string without_brackets(std::string text, const Symbols& symbols, Step& step) {
  const std::size_t from = text.find('[');
  if (from == std::string::npos) return text;
  if (text.back() != ']')
    throw SyntaxError(Mistake::syntax, from, "an assumption must end with ], at the end of the line");
  constexpr std::string_view small = "small ";
  const std::size_t first = text.find_first_not_of(' ', from + 1);
  const bool is_small = text.compare(first, small.size(), small) == 0;
  for (std::size_t at = is_small ? first + small.size() : from + 1; at < text.size();
       at = text.find_first_of(",]", at) + 1) {
    const std::size_t end = text.find_first_of(",]", at);
    const Relation part = parse_statement(std::string(at, ' ') + text.substr(at, end - at), symbols);
    if (part.operators.empty() != is_small || (is_small && part.sides[0]->kind != Node::Kind::symbol))
      throw SyntaxError(Mistake::assumption, at,
                        "an assumption must be a relation, [theta > 0], or [small theta, alpha]");
    if (is_small)
      step.small.push_back(part.sides[0]->text);
    else
      step.assumed.push_back(part);
  }
  return text.substr(0, from);
}

/// Reads a line that comes after `steps`, and adds its links.
void read_line(const Exercise& exercise, int number, const std::string& typed, std::vector<Step>& steps) {
  Step step{number, typed, {}, {}, {}};
  std::string text = without_brackets(typed, exercise.language(), step);
  const bool goes_on = text[0] == '=';
  if (goes_on) text[0] = ' ';
  if (goes_on && steps.empty()) throw SyntaxError(Mistake::syntax, 0, "the first line must not begin with =");
  Relation read = parse_statement(text, exercise.language());
  for (const auto& op : read.operators)
    if (op != "=")
      throw SyntaxError(Mistake::equation_wanted, 0, "the lines of a working must use =, not inequalities");
  const bool is_equation = exercise.kind == Kind::equation || names_of(read).contains(exercise.name) ||
                           (read.sides.size() > 1 && is_asked_for(exercise, read.sides[0]));
  Tree left;
  if (goes_on && !steps.back().says.operators.empty()) left = steps.back().says.sides[0];
  if (!goes_on && is_equation) {
    if (read.sides.size() == 1 && exercise.kind == Kind::equation && !exercise.name.empty())
      read.sides.insert(read.sides.begin(), parse(exercise.name, exercise.language()));
    if (read.sides.size() == 1)
      throw SyntaxError(Mistake::equation_wanted, 0, "an equation is expected: left = right");
    left = read.sides[0];
    read.sides.erase(read.sides.begin());
  }
  for (const auto& side : read.sides) {
    step.says = left == nullptr ? Relation{{side}, {}} : Relation{{left, side}, {"="}};
    steps.push_back(step);
  }
}

/// Returns a for "y_c = a", if y_c is what is asked for.
Relation as_value(const Exercise& exercise, const Relation& says) {
  const bool is_named =
      exercise.kind == Kind::expression && !says.operators.empty() && is_asked_for(exercise, says.sides[0]);
  return is_named ? Relation{{says.sides[1]}, {}} : says;
}

/// Returns what two steps say as statements of one kind: as expressions if possible, else as equations.
std::pair<Relation, Relation> of_one_kind(const Exercise& exercise, const Step& before, const Step& after) {
  std::pair<Relation, Relation> both{as_value(exercise, before.says), as_value(exercise, after.says)};
  if (both.first.operators == both.second.operators) return both;
  for (auto* one : {&both.first, &both.second})
    if (one->operators.empty()) *one = {{parse(exercise.name, exercise.language()), one->sides[0]}, {"="}};
  return both;
}

/// Decides a step that holds under its assumptions; nothing if it does not.
std::optional<Opinion> judge_assumed(const Prepared& step, const Step& after, const Relation& first,
                                     const Relation& second) {
  std::vector<Relation> assumed = step.assumed;
  assumed.insert(assumed.end(), after.assumed.begin(), after.assumed.end());
  if (contradict(assumed, step.symbols))
    return invalid(Slip::assumption,
                   "No numbers in the ranges of the symbols satisfy all that is assumed here.");
  const auto& given = step.answer.given;
  const Proof proof = after.small.empty()
                          ? decide::decide(second, first, step.symbols, given, assumed)
                          : decide_to_order(second, first, after.small, 1, step.symbols, given, assumed);
  if (is_right(proof.verdict) || proof.verdict == Verdict::approximation) return right_answer();
  if (proof.verdict == Verdict::undecided) return undecided(proof.reason);
  return {};
}

Opinion judge_step(const Prepared& whole, const Step& before, const Step& after) {
  const auto [first, second] = of_one_kind(whole.exercise, before, after);
  const Prepared step = prepare_step(whole, first, second);
  if (after.is_under_assumptions())
    if (const auto opinion = judge_assumed(step, after, first, second)) return *opinion;
  Opinion opinion;
  try {
    opinion = judge_formula(step, second);
  } catch (const SyntaxError& error) {
    return invalid(error, after.text);
  }
  if (exit_code(opinion) == 1 && !opinion.witness) opinion.witness = by_hand(step, second);
  if (exit_code(opinion) == 1 && !opinion.witness && first.operators.empty())
    opinion.witness = proof_of(step, second, first).witness;
  const Slip slip = opinion.note.slip;
  if (slip == Slip::small_angle || slip == Slip::not_linear)
    opinion.feedback =
        "It does for small angles only: say so at the end of the line, as in [small alpha, theta].";
  if (slip == Slip::other)
    opinion.feedback = std::string("It is none of the usual slips.") +
                       (opinion.witness ? " Try both at one point, by hand:" : "");
  return opinion;
}

/// Returns the value of a side of a line in base units: of a number with a unit, or of a formula whose
/// symbols have the values in `known`.
double side_value(const std::string& text, std::size_t from, std::size_t end, const RoughPoint& known,
                  const Symbols& symbols) {
  const std::string side = text.substr(from, end - from);
  try {
    return parse_quantity(side).value;
  } catch (const SyntaxError&) {
    return rough_value(parse(std::string(from, ' ') + side, symbols), known);
  }
}

/// Judges a line of a working of a number: a chain a = b = c that must be true to three digits with the
/// values in `known`. A symbol without a value there gets the first one that a line states.
Opinion judge_chain(const std::string& text, RoughPoint& known, const Symbols& symbols) {
  std::optional<double> before;
  std::string unknown;
  for (std::size_t from = 0, end; from <= text.size(); from = end + 1) {
    end = std::min(text.find('=', from), text.size());
    const double value = side_value(text, from, end, known, symbols);
    const bool is_new = std::isnan(value) && from == 0 && end < text.size();
    if (is_new) unknown = print(parse(text.substr(0, end), symbols));
    if (is_new) continue;
    if (!std::isfinite(value))
      throw SyntaxError(Mistake::not_real, from,
                        "this has no value, or it contains a symbol without a value");
    if (!unknown.empty()) known[std::exchange(unknown, "")] = value;
    if (before && !(std::abs(value - *before) <= 0.006 * std::abs(*before)))
      return wrong_answer(
          Slip::other, fmt::format("{} is {:.4g}, but the part before it is {:.4g}, with the numbers of the "
                                   "exercise.",
                                   trimmed(text.substr(from, end - from)), value, *before));
    before = value;
  }
  return right_answer();
}

/// Judges chains that must all be true; the last side of the last one is the answer.
Opinion judge_chains(const Prepared& whole, const std::vector<std::pair<int, std::string>>& lines,
                     const std::string& answer) {
  RoughPoint known;
  for (const auto& [name, value] : whole.answer.values) known[name] = rough_value(value, {});
  for (const auto& [number, text] : lines) {
    Opinion opinion;
    try {
      opinion = judge_chain(text, known, whole.symbols);
    } catch (const SyntaxError& error) {
      opinion = invalid(error, text);
    }
    opinion.line = number;
    if (opinion.outcome != Outcome::correct) return opinion;
  }
  Opinion opinion = judge_answer(whole, answer);
  if (exit_code(opinion) == 1 && lines.size() > 1)
    opinion.feedback = "Each line is true, but the last is not the answer. " + opinion.feedback;
  return opinion;
}

/// Reads all lines as steps. The opinion is that of the first line that cannot be read.
std::optional<Opinion> read_lines(const Exercise& exercise,
                                  const std::vector<std::pair<int, std::string>>& lines,
                                  std::vector<Step>& steps) {
  constexpr std::size_t most = 40;
  for (const auto& [number, text] : lines) {
    std::optional<Opinion> refused;
    try {
      const std::size_t before = steps.size();
      read_line(exercise, number, text, steps);
      for (std::size_t k = before; k < steps.size(); ++k)
        for (const auto& side : steps[k].says.sides)
          lower(side, exercise.language());  // refuses what is undefined, such as R/0
    } catch (const SyntaxError& error) {
      refused = invalid(error, text);
    }
    if (!refused && steps.size() > most)
      refused = invalid({"too_long"}, fmt::format("A working may have at most {} steps.", most));
    if (!refused) continue;
    refused->line = number;
    return refused;
  }
  return {};
}

/// Judges the steps into `result`. Returns false if its opinion is about one of them: the first that is
/// wrong, else the first that could not be decided.
bool judge_steps(const Exercise& exercise, const std::vector<Step>& steps, Working& result) {
  const Prepared whole = prepare(exercise);
  bool is_decided = true;
  for (std::size_t k = 1; k < steps.size(); ++k) {
    const Step &before = steps[k - 1], &after = steps[k];
    Opinion opinion = bounded([&] { return judge_step(whole, before, after); });
    opinion.line = after.line;
    const std::string from =
        before.line == after.line ? "the part before it" : fmt::format("line {}", before.line);
    if (opinion.outcome == Outcome::correct || opinion.outcome == Outcome::wrong_form) continue;
    if (opinion.outcome == Outcome::undecided) {
      opinion.feedback = fmt::format("Does it follow from {}? {}", from, opinion.feedback);
      if (is_decided) result.opinion = opinion;
      is_decided = false;
      continue;
    }
    if (exit_code(opinion) == 1)
      opinion.feedback = fmt::format("It does not follow from {}. {}", from, opinion.feedback);
    if (opinion.outcome == Outcome::correct_if) {
      opinion.outcome = Outcome::wrong;
      opinion.score = 0;
    }
    const auto [first, second] = of_one_kind(exercise, before, after);
    result.about = step_of(exercise, first, second);
    result.opinion = opinion;
    return false;
  }
  return is_decided;
}

}  // namespace

Working judge_working(const Exercise& exercise, const std::vector<std::pair<int, std::string>>& lines) {
  if (exercise.kind == Kind::number)
    if (const Prepared whole = prepare(exercise); !whole.answer.relation.sides.empty()) {
      const std::string& last = lines.back().second;
      const std::string answer = trimmed(last.substr(last.rfind('=') + 1));
      return {bounded([&] { return judge_chains(whole, lines, answer); }), answer, exercise};
    }
  if (!exercise.asks_for_formula())
    throw BadInput(
        fmt::format("'{0}' does not ask for a formula, so its working cannot be followed. Judge its answer "
                    "alone with {1} check {0} ANSWER",
                    exercise.id, exercise.course->program));
  Working result{{}, lines.back().second, exercise};
  std::vector<Step> steps;
  if (const auto refused = read_lines(exercise, lines, steps)) {
    result.opinion = *refused;
    return result;
  }
  result.answer = print_statement(as_value(exercise, steps.back().says), Notation::plain, {});
  if (!judge_steps(exercise, steps, result)) return result;
  Opinion& opinion = result.opinion = judge_bounded(exercise, result.answer);
  const bool is_exact = std::none_of(steps.begin() + 1, steps.end(),
                                     [](const Step& step) { return step.is_under_assumptions(); });
  if (opinion.outcome == Outcome::correct)
    opinion.feedback = "Right, and each line follows from the one before.";
  else if (steps.size() > 1)
    opinion.feedback =
        std::string("Each line follows from the one before, but the last is not the answer") +
        (is_exact && opinion.outcome == Outcome::wrong ? ", and so the first is wrong already. " : ". ") +
        opinion.feedback;
  return result;
}

}  // namespace rederive::classroom
