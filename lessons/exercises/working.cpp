// A working: a chain of lines, each of which must follow from the one before; the last one is the answer.
//
// A line is an equation, a chain a = b = c, or an expression, alone or behind a = sign. In an exercise that
// asks for an expression a line is an equation if it holds the quantity that is asked for: of y_c = a = b
// each side is compared with the one before. In brackets behind a line stands what is assumed there: [theta >
// 0, u_gddot = 0], or [small alpha, theta], by which a step need hold to first order only.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <derivations/paper/prove.hpp>
#include <derivations/program/program.hpp>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/units.hpp>

namespace rederive::classroom {
namespace {

/// What one link of a line says.
struct Step {
  int line = 0;
  std::string text;
  Relation says;                   ///< an equation, or an expression
  std::vector<Relation> assumed;   ///< for this step
  std::vector<std::string> small;  ///< symbols, to first order in which it is to hold
};

/// The line without what stands in brackets; that is read into the step, each part where it stands.
std::string without_brackets(std::string text, const Symbols& symbols, Step& step) {
  const std::size_t from = text.find('[');
  if (from == std::string::npos) return text;
  if (text.back() != ']')
    throw SyntaxError("syntax", from, "an assumption must end with ], at the end of the line");
  const std::string small = "small ";
  std::size_t at = text.find_first_not_of(' ', from + 1);
  const bool is_small = text.compare(at, small.size(), small) == 0;
  for (at = is_small ? at + small.size() : from + 1; at < text.size();
       at = text.find_first_of(",]", at) + 1) {
    const std::size_t end = text.find_first_of(",]", at);
    const Relation part = parse_statement(std::string(at, ' ') + text.substr(at, end - at), symbols);
    if (part.operators.empty() != is_small || (is_small && part.sides[0]->kind != Node::Kind::symbol))
      throw SyntaxError("assumption", at,
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
  if (goes_on && steps.empty()) throw SyntaxError("syntax", 0, "the first line must not begin with =");
  Relation read = parse_statement(text, exercise.language());
  for (const auto& op : read.operators)
    if (op != "=")
      throw SyntaxError("equation_wanted", 0, "the lines of a working must use =, not inequalities");
  const bool is_equation = exercise.kind == Kind::equation || names_of(read).contains(exercise.name) ||
                           (read.sides.size() > 1 && is_asked_for(exercise, read.sides[0]));
  Tree left;
  if (goes_on && !steps.back().says.operators.empty()) left = steps.back().says.sides[0];
  if (!goes_on && is_equation) {
    if (read.sides.size() == 1 && exercise.kind == Kind::equation && !exercise.name.empty())
      read.sides.insert(read.sides.begin(), parse(exercise.name, exercise.language()));
    if (read.sides.size() == 1)
      throw SyntaxError("equation_wanted", 0, "an equation is expected: left = right");
    left = read.sides[0];
    read.sides.erase(read.sides.begin());
  }
  for (const auto& side : read.sides) {
    step.says = left == nullptr ? Relation{{side}, {}} : Relation{{left, side}, {"="}};
    steps.push_back(step);
  }
}

/// "y_c = a" as a, where y_c is what is asked for.
Relation as_value(const Exercise& exercise, const Relation& says) {
  const bool is_named =
      exercise.kind == Kind::expression && !says.operators.empty() && is_asked_for(exercise, says.sides[0]);
  return is_named ? Relation{{says.sides[1]}, {}} : says;
}

/// The two as statements of one kind: expressions, else equations.
std::pair<Relation, Relation> of_one_kind(const Exercise& exercise, const Step& before, const Step& after) {
  std::pair<Relation, Relation> both{as_value(exercise, before.says), as_value(exercise, after.says)};
  if (both.first.operators == both.second.operators) return both;
  for (auto* one : {&both.first, &both.second})
    if (one->operators.empty()) *one = {{parse(exercise.name, exercise.language()), one->sides[0]}, {"="}};
  return both;
}

Opinion judge_step(const Prepared& whole, const Step& before, const Step& after) {
  const auto [first, second] = of_one_kind(whole.exercise, before, after);
  const Prepared step = prepare_step(whole, first, second);
  if (!after.assumed.empty() || !after.small.empty()) {
    std::vector<Relation> assumed = step.assumed;
    assumed.insert(assumed.end(), after.assumed.begin(), after.assumed.end());
    if (contradict(assumed, step.symbols))
      return invalid("assumption",
                     "No numbers in the ranges of the symbols satisfy all that is assumed here.");
    const auto& given = step.answer.given;
    const Proof proof = after.small.empty()
                            ? decide(second, first, step.symbols, given, assumed)
                            : decide_to_order(second, first, after.small, 1, step.symbols, given, assumed);
    if (is_right(proof.verdict) || proof.verdict == Verdict::approximation)
      return found({}, "correct", "correct", "Right.", 1);
    if (proof.verdict == Verdict::undecided)
      return found({}, "undecided", "undecided", "This could not be decided: " + proof.reason, 0);
  }
  Opinion opinion;
  try {
    opinion = judge_formula(step, second);
  } catch (const SyntaxError& error) {
    return invalid(error, after.text);
  }
  if (opinion.note == "small_angle" || opinion.note == "not_linear")
    opinion.feedback =
        "It does for small angles only: say so at the end of the line, as in [small alpha, theta].";
  if (exit_code(opinion) == 1 && !opinion.witness) opinion.witness = by_hand(step, second);
  if (exit_code(opinion) == 1 && !opinion.witness && first.operators.empty())
    opinion.witness = proof_of(step, second, first).witness;
  if (opinion.note == "other")
    opinion.feedback = std::string("It is none of the usual slips.") +
                       (opinion.witness ? " Try both at one point, by hand:" : "");
  return opinion;
}

/// What a side of a line is worth in base units: a number with a unit, or a formula of symbols with values.
double side_value(const std::string& text, std::size_t from, std::size_t end, const RoughPoint& known,
                  const Symbols& symbols) {
  const std::string side = text.substr(from, end - from);
  try {
    return parse_quantity(side).value;
  } catch (const SyntaxError&) {
    return rough_value(parse(std::string(from, ' ') + side, symbols), known);
  }
}

/// A line of a working of a number: a chain a = b = c that is true to three digits with the values that are
/// known. A symbol that has none before gets the value that it is first said to have.
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
      throw SyntaxError("not_real", from, "this has no value, or it contains a symbol without a value");
    if (!unknown.empty()) known[std::exchange(unknown, "")] = value;
    if (before && !(std::abs(value - *before) <= 0.006 * std::abs(*before)))
      return found({}, "wrong", "other",
                   fmt::format("{} is {:.4g}, but the part before it is {:.4g}, with the numbers "
                               "of the exercise.",
                               trimmed(text.substr(from, end - from)), value, *before),
                   0);
    before = value;
  }
  return found({}, "correct", "correct", "Right.", 1);
}

/// Chains that are all true, and the last side of the last is the answer.
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
    if (opinion.verdict != "correct") return opinion;
  }
  Opinion opinion = judge_answer(whole, answer);
  if (exit_code(opinion) == 1 && lines.size() > 1)
    opinion.feedback = "Each line is true, but the last is not the answer. " + opinion.feedback;
  return opinion;
}

}  // namespace

Working judge_working(const Exercise& exercise, const std::vector<std::pair<int, std::string>>& lines) {
  if (exercise.kind == Kind::number)
    if (const Prepared whole = prepare(exercise); !whole.answer.relation.sides.empty()) {
      const std::string& last = lines.back().second;
      const std::string answer = trimmed(last.substr(last.rfind('=') + 1));
      return {bounded([&] { return judge_chains(whole, lines, answer); }), answer, exercise};
    }
  if (exercise.kind != Kind::expression && exercise.kind != Kind::equation)
    throw BadInput(
        fmt::format("'{0}' does not ask for a formula, so its working cannot be followed. Judge its answer "
                    "alone with exercises check {0} ANSWER",
                    exercise.id));
  constexpr std::size_t most = 40;
  Working result{{}, lines.back().second, exercise};
  std::vector<Step> steps;
  for (const auto& [number, text] : lines) {
    const auto refused = [&, number = number](const Opinion& opinion) {
      result.opinion = opinion;
      result.opinion.line = number;
      return result;
    };
    try {
      const std::size_t before = steps.size();
      read_line(exercise, number, text, steps);
      for (std::size_t k = before; k < steps.size(); ++k)
        for (const auto& side : steps[k].says.sides)
          lower(side, exercise.language());  // refuses what is undefined, such as R/0
    } catch (const SyntaxError& error) {
      return refused(invalid(error, text));
    }
    if (steps.size() > most)
      return refused(invalid("too_long", fmt::format("A working may have at most {} steps.", most)));
  }
  const Relation last = as_value(exercise, steps.back().says);
  result.answer = last.operators.empty() ? print(last.sides[0]) : print(last);
  const Prepared whole = prepare(exercise);
  std::optional<Opinion> open;  // the first step that could not be decided
  bool is_exact = true;
  for (std::size_t k = 1; k < steps.size(); ++k) {
    const Step &before = steps[k - 1], &after = steps[k];
    is_exact = is_exact && after.assumed.empty() && after.small.empty();
    Opinion opinion = bounded([&] { return judge_step(whole, before, after); });
    opinion.line = after.line;
    const std::string from =
        before.line == after.line ? "the part before it" : fmt::format("line {}", before.line);
    if (opinion.verdict == "correct" || opinion.verdict == "wrong_form") continue;
    if (opinion.verdict == "undecided") {
      opinion.feedback = fmt::format("Does it follow from {}? {}", from, opinion.feedback);
      if (!open) open = opinion;
      continue;
    }
    if (exit_code(opinion) == 1)
      opinion.feedback = fmt::format("It does not follow from {}. {}", from, opinion.feedback);
    if (opinion.verdict == "correct_if") opinion.verdict = "wrong", opinion.score = 0;
    const auto [first, second] = of_one_kind(exercise, before, after);
    result.about = as_exercise(exercise, first, second);
    result.opinion = opinion;
    return result;
  }
  if (open) return {*open, result.answer, exercise};
  Opinion& opinion = result.opinion = judge_bounded(exercise, result.answer);
  if (opinion.verdict == "correct")
    opinion.feedback = "Right, and each line follows from the one before.";
  else if (steps.size() > 1)
    opinion.feedback =
        std::string("Each line follows from the one before, but the last is not the answer") +
        (is_exact && opinion.verdict == "wrong" ? ", and so the first is wrong already. " : ". ") +
        opinion.feedback;
  return result;
}

}  // namespace rederive::classroom
