// Expressions and equations: right by proof, wrong by the first wrong road that leads to the same formula.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <derivations/paper/mutate.hpp>
#include <derivations/rocking_block/paper_symbols.hpp>
#include <lessons/exercises/edits.hpp>
#include <lessons/exercises/judge.hpp>

namespace rederive::classroom {
namespace {

bool is_right(Verdict verdict) { return verdict == Verdict::proved || verdict == Verdict::proved_under; }

/// left - right of an equation, as an expression.
Relation residual_of(const Relation& equation) {
  const auto residual = std::make_shared<Node>(
      Node{Node::Kind::sum, "", {equation.sides[0], equation.sides[1]}, {false, true}, 0});
  return {{residual}, {}};
}

/// "-3/2" as a tree, where the number is such a fraction.
std::optional<Tree> small_fraction(double value) {
  for (int under = 1; under <= 360; ++under) {
    const double over = std::round(std::abs(value) * under);
    if (over < 1 || over > 1e6 || std::abs(std::abs(value) * under - over) > 1e-9 * over) continue;
    const Tree size = scaled(fmt::format("{:.0f}", over), std::to_string(under), number("1"));
    return value < 0 ? negative(size) : size;
  }
  return {};
}

/// Two equations that differ by a number only: then one residual is that multiple of the other, identically.
std::optional<Proof> same_up_to_a_number(const Prepared& prepared, const Relation& read,
                                         const Relation& against) {
  const Relation mine = residual_of(read), right = residual_of(against);
  const auto a = signature(put_in(mine, prepared.answer.given), "", prepared.points);
  const auto b = signature(put_in(right, prepared.answer.given), "", prepared.points);
  const auto ratio = a && b ? common_ratio(*a, *b) : std::nullopt;
  const auto factor = ratio ? small_fraction(*ratio) : std::nullopt;
  if (!factor) return {};
  const auto multiple =
      std::make_shared<Node>(Node{Node::Kind::product, "", {*factor, right.sides[0]}, {false, false}, 0});
  const Proof proof = prove(mine, Relation{{multiple}, {}}, paper_symbols(), prepared.answer.given);
  return is_right(proof.verdict) ? std::optional(proof) : std::nullopt;
}

Proof proof_of(const Prepared& prepared, const Relation& read, const Relation& against) {
  const bool equations =
      read.operators == std::vector<std::string>{"="} && against.operators == read.operators;
  if (equations)
    if (const auto proof = same_up_to_a_number(prepared, read, against)) return *proof;
  return prove(read, against, paper_symbols(), prepared.answer.given);
}

const Node* find_symbol(const Tree& tree, const std::string& name) {
  if (tree->kind == Node::Kind::symbol && tree->text == name) return tree.get();
  for (const auto& child : tree->children)
    if (const Node* found = find_symbol(child, name)) return found;
  return nullptr;
}

/// Refuses symbols that the exercise does not give, where they stand.
void check_symbols(const Exercise& exercise, const Relation& read) {
  std::string allowed;
  for (const auto& name : exercise.symbols) allowed += (allowed.empty() ? "" : ", ") + name;
  for (const auto& name : symbols_in(read)) {
    const auto& names = exercise.symbols;
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    for (const auto& side : read.sides)
      if (const Node* node = find_symbol(side, name))
        throw SyntaxError("symbol_not_given", node->position,
                          fmt::format("'{}' is not among the symbols of this exercise: {}", name, allowed));
  }
}

/// Text → the statement to judge: of "y_c = ..." the right side where an expression is asked for and y_c is
/// its name.
Relation read_answer(const Exercise& exercise, const std::string& text) {
  Relation read = parse_statement(text);
  const bool named = !exercise.name.empty() && read.sides.size() == 2 && read.operators[0] == "=" &&
                     read.sides[0]->kind == Node::Kind::symbol && read.sides[0]->text == exercise.name;
  if (exercise.kind == Kind::expression) {
    if (named) read = {{read.sides[1]}, {}};
    if (!read.operators.empty())
      throw SyntaxError("expression_wanted", 0, "an expression is wanted here, without a relation sign");
  } else {
    if (read.operators.empty() && !exercise.name.empty())
      read = {{parse(exercise.name), read.sides[0]}, {"="}};
    if (read.operators.empty())
      throw SyntaxError("equation_wanted", text.size(), "an equation is wanted here: left side = right side");
    if (read.operators.size() > 1)
      throw SyntaxError("one_relation_wanted", 0, "one relation is wanted here, not a chain of them");
  }
  Relation checked = read;
  if (exercise.kind == Kind::equation && named) checked.sides.erase(checked.sides.begin());
  check_symbols(exercise, checked);
  return read;
}

std::optional<Signature> signature_of(const Prepared& prepared, const Relation& read) {
  return signature(put_in(read, prepared.answer.given), prepared.exercise.pivot, prepared.points);
}

Opinion found(Opinion opinion, const std::string& verdict, const std::string& note, const std::string& says,
              double score) {
  opinion.verdict = verdict;
  opinion.note = note;
  opinion.feedback = says;
  opinion.score = score;
  return opinion;
}

/// Is the dimension of the answer wrong? Says how; nothing if it is right.
std::optional<std::string> wrong_dimension(const Prepared& prepared, const Relation& read) {
  const auto report = read.operators.empty() ? dimension(read.sides[0]) : dimension(read);
  if (!report.consistent) return "In your answer, " + report.explanation + ".";
  if (!read.operators.empty() || !report.dimension) return {};
  const auto wanted = dimension(prepared.answer.relation.sides[0]);
  if (!wanted.consistent || !wanted.dimension || *wanted.dimension == *report.dimension) return {};
  return fmt::format("Your answer has the unit {}, but {} is wanted.", unit_text(*report.dimension),
                     unit_text(*wanted.dimension));
}

/// How far apart two signatures are, in proportion to the second.
double distance(const Signature& left, const Signature& right) {
  double error = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    error = std::max(error, std::abs(left[i] - right[i]) / (std::abs(right[i]) + 1e-300));
  return error;
}

Signature minus(const Signature& left, const Signature& right) {
  Signature result = left;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] -= right[i];
  return result;
}

/// Does the answer approach the right one as all angles (or the rotation alone) go to zero? Compared is what
/// the angles change, so that 1 + wrong*alpha^2 is not taken for 1 + right*alpha^2; an answer without any
/// angle is compared whole.
bool right_for_small_angles(const Prepared& prepared, const Relation& read, bool rotations_only) {
  const Relation mine = put_in(read, prepared.answer.given),
                 right = put_in(prepared.answer.relation, prepared.answer.given);
  std::set<std::string> names = symbols_in(mine);
  names.merge(symbols_in(right));
  const auto at = [&](const Relation& statement, const cln::cl_RA& scale) {
    return signature(statement, prepared.exercise.pivot, sample_points(names, 2, scale, rotations_only));
  };
  const auto mine_at_zero = at(mine, 0), right_at_zero = at(right, 0);
  double before = 1;
  for (const int shrink : {40, 400}) {
    auto a = at(mine, cln::cl_RA(1) / shrink), b = at(right, cln::cl_RA(1) / shrink);
    if (!a || !b) return false;
    const bool varies = mine_at_zero && right_at_zero && !alike(*a, *mine_at_zero);
    if (varies) a = minus(*a, *mine_at_zero), b = minus(*b, *right_at_zero);
    const double error = distance(*a, *b);
    if (error > before / 8 || (shrink == 40 && error > 0.1)) return false;
    before = error;
  }
  return !mine_at_zero || !right_at_zero || alike(*mine_at_zero, *right_at_zero);
}

std::optional<Opinion> by_roads(const Prepared& prepared, const Relation& read, const Signature& mine,
                                const Opinion& start) {
  for (const auto& road : prepared.roads) {
    if (!road.signature || !alike(mine, *road.signature)) continue;
    if (!is_right(proof_of(prepared, read, road.relation).verdict)) continue;
    return found(start, road.verdict, road.note, road.says, road.verdict == "correct_if" ? 0.5 : 0);
  }
  return {};
}

/// A whole answer off by a factor: minus one, another number, or turned upside down.
std::optional<std::string> off_by_a_factor(const Prepared& prepared, const Signature& mine) {
  if (prepared.exercise.kind == Kind::equation && prepared.exercise.pivot.empty()) return {};
  if (const auto ratio = common_ratio(mine, *prepared.signature); ratio && *ratio != 0)
    return std::abs(*ratio + 1) < 1e-9 ? "sign" : "factor";
  Signature upside_down = mine;
  for (double& number : upside_down) number = 1 / number;
  if (alike(upside_down, *prepared.signature)) return "reciprocal";
  return {};
}

/// What the answer depends on, against what it should depend on.
std::optional<std::string> wrong_symbols(const Prepared& prepared, const Relation& read) {
  const auto mine = symbols_in(put_in(read, prepared.answer.given));
  const auto right = symbols_in(put_in(prepared.answer.relation, prepared.answer.given));
  if (!std::includes(mine.begin(), mine.end(), right.begin(), right.end())) return "missing_symbol";
  if (!std::includes(right.begin(), right.end(), mine.begin(), mine.end())) return "extra_symbol";
  return {};
}

Opinion why_wrong(const Prepared& prepared, const Relation& read, const std::optional<Signature>& mine,
                  const Proof& proof, const Opinion& start) {
  const bool comparable = mine && prepared.signature;
  if (comparable)
    if (auto opinion = by_roads(prepared, read, *mine, start)) return *opinion;
  if (const auto why = wrong_dimension(prepared, read))
    return found(start, "wrong", "dimension", explanation_of("dimension") + " " + *why, 0);
  if (comparable)
    if (const auto note = off_by_a_factor(prepared, *mine))
      return found(start, "wrong", *note, explanation_of(*note), 0);
  if (right_for_small_angles(prepared, read, false) || right_for_small_angles(prepared, read, true))
    return found(start, "correct_if", "small_angle", explanation_of("small_angle"), 0.5);
  if (const auto note = wrong_symbols(prepared, read))
    return found(start, "wrong", *note, explanation_of(*note), 0);
  Opinion opinion = found(start, "wrong", "other", explanation_of("other"), 0);
  opinion.witness = proof.witness;
  return opinion;
}

Road road_to(const Prepared& prepared, const Relation& relation, const std::string& note,
             const std::string& says, const std::string& verdict = "wrong") {
  return {note, says, verdict, relation, signature_of(prepared, relation), 0};
}

Relation with_put(const Relation& relation, const std::map<std::string, std::string>& values) {
  Relation result = relation;
  for (const auto& [name, value] : values)
    for (auto& side : result.sides) side = put_in(side, name, parse(value));
  return result;
}

/// The right answer with one slip in it, if that is not said better by its dimensions and is not right
/// itself.
void add_slip(Prepared& prepared, const Relation& relation, const std::string& note) {
  const bool dotless = note == "missing_dot";
  if (!dotless &&
      !dimension(relation.operators.empty() ? Relation{{relation.sides[0]}, {}} : relation).consistent)
    return;
  Road road = road_to(prepared, relation, dotless ? "dimension" : note, explanation_of(note));
  if (dotless)
    road.says =
        explanation_of("dimension") + " Is there a dot missing somewhere: a rate written as what changes?";
  if (prepared.signature && road.signature && !alike(*road.signature, *prepared.signature))
    prepared.roads.push_back(road);
}

}  // namespace

void add_roads(Prepared& prepared) {
  const Exercise& exercise = prepared.exercise;
  for (const auto& slip : exercise.slips) {
    if (exercise.kind == Kind::number) {
      Road road{slip.note, slip.says, "wrong", {}, {}, 0};
      const auto typed =
          slip.typed.empty() ? 0 : GiNaC::ex_to<GiNaC::numeric>(lower(parse(slip.typed)).evalf()).to_double();
      road.number = slip.road ? resolve(*slip.road, exercise.kind).number : typed;
      prepared.roads.push_back(road);
      continue;
    }
    const Relation relation =
        slip.road ? resolve(*slip.road, exercise.kind).relation : parse_statement(slip.typed);
    prepared.roads.push_back(road_to(prepared, relation, slip.note, slip.says));
  }
  if (exercise.kind == Kind::number) return;
  for (const auto& assumption : exercise.assumptions)
    prepared.roads.push_back(road_to(prepared, with_put(prepared.answer.relation, assumption.put),
                                     "assumption", assumption.says, "correct_if"));
  for (const auto& edit : edits(prepared.answer.relation)) add_slip(prepared, edit.relation, edit.note);
  static const std::map<std::string, std::string> notes{
      {"sign", "sign"},         {"coefficient", "factor"},    {"function", "sin_cos"}, {"square", "power"},
      {"term", "missing_term"}, {"factor", "missing_factor"}, {"dot", "missing_dot"}};
  for (const auto& mutant :
       mutants(prepared.answer.relation))  // the slips that the ledger tries on a printed row
    if (const auto note = notes.find(mutant.slip); note != notes.end())
      add_slip(prepared, mutant.relation, note->second);
}

Opinion judge_formula(const Prepared& prepared, const std::string& text) {
  Opinion opinion;
  Relation read;
  try {
    read = read_answer(prepared.exercise, text);
    opinion.read_as = read.operators.empty() ? print(read.sides[0]) : print(read);
    for (const auto& side : read.sides) lower(side);  // refuses what is undefined at once, such as 1/0
  } catch (const SyntaxError& error) {
    return invalid(error, text);
  }
  const auto mine = signature_of(prepared, read);
  const bool surely_different = mine && prepared.signature && !alike(*mine, *prepared.signature) &&
                                (read.operators.empty() || !prepared.exercise.pivot.empty());
  const Proof proof = proof_of(prepared, read, prepared.answer.relation);
  if (is_right(proof.verdict)) {
    if (const auto why = not_in_form(prepared.exercise, read))
      return found(opinion, "wrong_form", "form", *why, 0.5);
    return found(opinion, "correct", "correct", "Right.", 1);
  }
  if (proof.verdict == Verdict::undecided && !surely_different)
    return found(opinion, "undecided", "undecided", "This could not be decided: " + proof.reason, 0);
  return why_wrong(prepared, read, mine, proof, opinion);
}

}  // namespace rederive::classroom
