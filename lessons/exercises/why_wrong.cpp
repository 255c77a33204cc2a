// What to say of a formula that is wrong: the first of these that is certain.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <lessons/exercises/judge.hpp>
#include <lessons/exercises/repairs.hpp>
#include <lessons/page/prose.hpp>

namespace rederive::classroom {
namespace {

/// Is the dimension of the answer wrong? Says how; nothing if it is right.
std::optional<std::string> wrong_dimension(const Prepared& prepared, const Relation& read) {
  const auto report =
      read.operators.empty() ? dimension(read.sides[0], prepared.symbols) : dimension(read, prepared.symbols);
  if (!report.consistent)
    return "In your answer, " + marked(report.explanation, prepared.exercise.paper()) + ".";
  if (!read.operators.empty() || !report.dimension) return {};
  const auto wanted = dimension(prepared.answer.relation.sides[0], prepared.symbols);
  if (!wanted.consistent || !wanted.dimension || *wanted.dimension == *report.dimension) return {};
  return fmt::format("Your answer has the unit {}, but it should have {}.",
                     marked(unit_text(*report.dimension), prepared.exercise.paper()),
                     marked(unit_text(*wanted.dimension), prepared.exercise.paper()));
}

/// How far apart two signatures are, in proportion to the second.
double distance(const Signature& left, const Signature& right) {
  double error = 0;
  for (std::size_t i = 0; i < left.size(); ++i)
    error = std::max(error, std::abs(left[i] - right[i]) / (std::abs(right[i]) + 1e-300));
  return error;
}

/// The answer and the right one at points whose angles (or rotations alone) shrink.
class SmallAngles {
 public:
  SmallAngles(const Prepared& prepared, const Relation& read, bool rotations_only)
      : mine_(put_in(read, prepared.answer.given, prepared.symbols)),
        right_(put_in(prepared.answer.relation, prepared.answer.given, prepared.symbols)),
        symbols_(prepared.symbols),
        assumed_(prepared.assumed),
        pivot_(prepared.exercise.pivot),
        rotations_only_(rotations_only) {
    names_ = names_of(mine_);
    names_.merge(names_of(right_));
  }

  /// Does the answer approach the right one? Compared is what the angles change, so that 1 + wrong*alpha^2 is
  /// not taken for 1 + right*alpha^2, nor 1 for it; without a value at 0 the answer is compared whole.
  bool agree() const {
    const auto mine_at_zero = at(mine_, 0), right_at_zero = at(right_, 0);
    double before = 1;
    for (const int shrink : {40, 400}) {
      auto a = at(mine_, cln::cl_RA(1) / shrink), b = at(right_, cln::cl_RA(1) / shrink);
      if (!a || !b) return false;
      const bool varies = mine_at_zero && right_at_zero;
      if (varies && alike(*a, *mine_at_zero)) return false;
      for (std::size_t i = 0; varies && i < a->size(); ++i)
        (*a)[i] -= (*mine_at_zero)[i], (*b)[i] -= (*right_at_zero)[i];
      const double error = distance(*a, *b);
      if (error > before / 8 || (shrink == 40 && error > 0.1)) return false;
      before = error;
    }
    return !mine_at_zero || !right_at_zero || alike(*mine_at_zero, *right_at_zero);
  }

  /// Is the right answer linear in the angles? Then it is the other one that was not linearised.
  bool right_is_linear() const {
    const auto none = at(right_, 0), half = at(right_, cln::cl_RA(1) / 2), whole = at(right_, 1);
    if (!none || !half || !whole || alike(*none, *whole)) return false;
    Signature mean = *none;
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] = (mean[i] + (*whole)[i]) / 2;
    return alike(mean, *half);
  }

 private:
  std::optional<Signature> at(const Relation& statement, const cln::cl_RA& scale) const {
    return signature(statement, pivot_, sample_points(names_, 2, symbols_, assumed_, scale, rotations_only_));
  }

  Relation mine_, right_;
  const Symbols& symbols_;
  const std::vector<Relation>& assumed_;
  std::string pivot_;
  bool rotations_only_;
  std::set<std::string> names_;
};

std::optional<Opinion> by_roads(const Prepared& prepared, const Relation& read, const Signature& mine,
                                const Opinion& start) {
  for (const auto& road : prepared.roads) {
    if (!road.signature || !alike(mine, *road.signature)) continue;
    if (!is_right(proof_of(prepared, read, road.relation).verdict)) continue;
    return found(start, road.verdict, road.note, road.says, road.verdict == "correct_if" ? 0.5 : 0);
  }
  return {};
}

/// Which symbols that an answer may use the first statement has and the second has not.
std::vector<std::string> symbols_missing(const Prepared& prepared, const Relation& first,
                                         const Relation& second) {
  const auto names = names_of(put_in(first, prepared.answer.given, prepared.symbols)),
             others = names_of(put_in(second, prepared.answer.given, prepared.symbols));
  std::vector<std::string> missing;
  std::set_difference(names.begin(), names.end(), others.begin(), others.end(), std::back_inserter(missing));
  return missing;
}

/// What the answer depends on, against what it should depend on.
std::optional<Opinion> for_symbols(const Prepared& prepared, const Relation& read, const Opinion& start) {
  const Relation& right = prepared.answer.relation;
  for (const bool is_missing : {true, false}) {
    std::vector<std::string> names =
        is_missing ? symbols_missing(prepared, right, read) : symbols_missing(prepared, read, right);
    if (names.empty()) continue;
    const auto& known = prepared.exercise.symbols;
    std::erase_if(names, [&](const auto& name) { return std::ranges::find(known, name) == known.end(); });
    const std::string list = joined(names, ", ", [](const auto& name) { return "$" + name + "$"; });
    const std::string note = is_missing ? "missing_symbol" : "extra_symbol";
    const std::string says = slip_words("answer", note);
    return found(start, "wrong", note, fmt::format(fmt::runtime(says), list.empty() ? "" : ": " + list), 0);
  }
  return {};
}

std::optional<Opinion> for_small_angles(const Prepared& prepared, const Relation& read,
                                        const Opinion& start) {
  for (const bool rotations_only : {false, true}) {
    const SmallAngles angles(prepared, read, rotations_only);
    if (!angles.agree()) continue;
    return angles.right_is_linear()
               ? found(start, "wrong", "not_linear", slip_words("answer", "not_linear"), 0)
               : found(start, "correct_if", "small_angle", slip_words("answer", "small_angle"), 0.5);
  }
  return {};
}

}  // namespace

Opinion why_wrong(const Prepared& prepared, const Relation& read, const std::optional<Signature>& mine,
                  const Opinion& start) {
  if (mine)
    if (auto opinion = by_roads(prepared, read, *mine, start)) return *opinion;
  const auto is_mended = [&](const Repair& repair) {
    return is_right(proof_of(prepared, repair.relation, prepared.answer.relation).verdict);
  };
  const bool is_alike = mine && prepared.signature && alike(*mine, *prepared.signature);
  const bool differs = mine && prepared.signature && !is_alike;  // beyond doubt
  const bool agrees =
      !differs && prepared.sieve && !prepared.sieve->is_empty() && prepared.sieve->passes(read);
  std::vector<Relation> forms{prepared.answer.relation};
  for (const auto& text : prepared.exercise.equivalents)
    forms.push_back(parse_statement(text, prepared.symbols));
  const auto repair = prepared.sieve && !agrees
                          ? repaired(read, forms, *prepared.sieve, prepared.exercise, is_mended)
                          : std::nullopt;
  if (const auto why = wrong_dimension(prepared, read))
    return found(start, "wrong", "dimension",
                 slip_words("answer", "dimension") + " " + *why +
                     (repair && repair->part != nullptr && repair->part->kind != Node::Kind::number
                          ? " Look at $" + print(repair->part) + "$."
                          : ""),
                 0);
  if (repair && repair->note == "taken_away")
    if (auto opinion = for_symbols(prepared, read, start); opinion && opinion->note == "missing_symbol")
      return *opinion;
  if (repair) return found(start, "wrong", repair->note, in_words(*repair), 0);
  if (!is_alike)
    if (auto opinion = for_small_angles(prepared, read, start)) return *opinion;
  if (auto opinion = for_symbols(prepared, read, start)) return *opinion;
  const std::string note = agrees || is_alike ? "not_everywhere" : "other";
  Opinion opinion = found(start, "wrong", note, slip_words("answer", note), 0);
  opinion.witness = by_hand(prepared, read);
  if (opinion.witness) opinion.feedback += " Try it at one point, by hand:";
  return opinion;
}

}  // namespace rederive::classroom
